# what is compiled
from collections.abc import Mapping
from os import PathLike
from typing import Any, Final, Protocol, final, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import Outcome, Table

__all__ = [
    "Column",
    "Contact",
    "Impact",
    "__version__",
    "arrow_stream",
    "calibrate",
    "find",
    "laws",
    "materials",
    "numeric_keys",
    "rows",
    "run",
    "schema",
    "table_of_csv",
    "validated",
]

__version__: str

# a table of a scenario: its values are numbers in SI units, texts with a unit, or inner tables
_Keys = Mapping[str, Any]

# numbers that have a shape: lists, arrays, a Series
class _HasArray(Protocol):
    def __array__(self) -> Any: ...

_Array = list[Any] | tuple[Any, ...] | _HasArray

# columns by their names: a dict of arrays, a Table, a DataFrame, a table of Arrow
class _Columns(Protocol):
    def __getitem__(self, name: str, /) -> Any: ...

@final
class Contact:
    def __new__(cls, *, sphere: _Keys, half_space: _Keys, **tables: _Keys | str) -> Contact: ...
    def __eq__(self, other: object, /) -> bool: ...
    def __hash__(self) -> int: ...
    @property
    def _law(self) -> str: ...
    @property
    def mass_kg(self) -> float: ...
    @property
    def reduced_mass_kg(self) -> float: ...
    @property
    def yield_speed_m_per_s(self) -> float | None: ...
    @property
    def yield_indentation_m(self) -> float | None: ...
    @property
    def yield_force_N(self) -> float | None: ...
    @overload
    def restitution(self, speed: float | str) -> float: ...
    @overload
    def restitution(self, speed: _Array) -> NDArray[np.float64]: ...
    def impact(self, speed: float | str | None = None, *, samples: int | None = None) -> Impact: ...
    @overload
    def force(self, indentation: float, memory: ArrayLike | None = None) -> tuple[float, NDArray[np.float64]]: ...
    @overload
    def force(
        self, indentation: _Array, memory: ArrayLike | None = None
    ) -> tuple[NDArray[np.float64], NDArray[np.float64]]: ...
    @overload
    def energy(self, indentation: float, memory: ArrayLike) -> tuple[float, float]: ...
    @overload
    def energy(self, indentation: _Array, memory: ArrayLike) -> tuple[NDArray[np.float64], NDArray[np.float64]]: ...
    @overload
    def stiffness(self, indentation: float, memory: ArrayLike | None = None) -> float: ...
    @overload
    def stiffness(self, indentation: _Array, memory: ArrayLike | None = None) -> NDArray[np.float64]: ...
    def header(self, name: str = "pair") -> dict[str, str]: ...
    def friction(
        self,
        coefficient: float,
        previous_indentation: float | _Array,
        indentation: float | _Array,
        memory: ArrayLike,
        slip: ArrayLike,
        history: ArrayLike | None = None,
    ) -> NDArray[np.float64]: ...

@final
class Impact:
    restitution: Final[float | None]
    warnings: Final[list[str]]
    # every other result of summary.json, by its name
    # results: written by a test
    accuracy: Final[Any]
    air_loss_fraction: Final[Any]
    compressive_layer_depth_m: Final[Any]
    compressive_layer_depth_sd_m: Final[Any]
    contact_point_restitution: Final[Any]
    contact_radius_over_R: Final[Any]
    contact_time_s: Final[Any]
    coverage_after_time: Final[Any]
    dent_area_m2: Final[Any]
    dent_depth_interval_m: Final[Any]
    dent_depth_interval_text: Final[Any]
    dent_depth_m: Final[Any]
    dent_diameter_interval_m: Final[Any]
    dent_diameter_interval_text: Final[Any]
    dent_diameter_m: Final[Any]
    effective_modulus_Pa: Final[Any]
    elastic_approach_m: Final[Any]
    end_indentation_m: Final[Any]
    end_time_s: Final[Any]
    energy: Final[Any]
    flat_depth_m: Final[Any]
    flat_diameter_m: Final[Any]
    friction_error: Final[Any]
    friction_loss_fraction: Final[Any]
    impacts_for_coverage_per_m2: Final[Any]
    impulse_ratio: Final[Any]
    leeb_hardness_HL: Final[Any]
    leeb_scale: Final[Any]
    loading_time_s: Final[Any]
    mass_for_coverage_kg_per_m2: Final[Any]
    notes: Final[Any]
    outcome: Final[Any]
    peak_contact_radius_m: Final[Any]
    peak_force_N: Final[Any]
    peak_indentation_m: Final[Any]
    peak_mean_pressure_Pa: Final[Any]
    peak_sphere_indentation_m: Final[Any]
    plastic_zone_depth_m: Final[Any]
    plastic_zone_depth_sd_m: Final[Any]
    plate_displacement_m: Final[Any]
    plate_loss_fraction: Final[Any]
    plate_wave_reach_m: Final[Any]
    plate_wave_transits: Final[Any]
    psi_1: Final[Any]
    psi_2: Final[Any]
    pulse: Final[Any]
    rate_factor: Final[Any]
    rate_factor_at_peak: Final[Any]
    rebound_angle_deg: Final[Any]
    rebound_azimuth_deg: Final[Any]
    rebound_cross_speed_m_per_s: Final[Any]
    rebound_height_m: Final[Any]
    rebound_speed_m_per_s: Final[Any]
    rebound_spin_about_normal_rad_per_s: Final[Any]
    rebound_spin_about_path_rad_per_s: Final[Any]
    rebound_spin_rad_per_s: Final[Any]
    rebound_tangential_speed_m_per_s: Final[Any]
    residual_compression_Pa: Final[Any]
    residual_compression_sd_Pa: Final[Any]
    residual_indentation_m: Final[Any]
    residual_radius_m: Final[Any]
    restitution_interval: Final[Any]
    restitution_interval_parts: Final[Any]
    restitution_interval_text: Final[Any]
    restitution_with_adhesion: Final[Any]
    restitution_with_waves: Final[Any]
    rod_displacement_m: Final[Any]
    rod_loss_fraction: Final[Any]
    rod_peak_stress_Pa: Final[Any]
    rod_wave_reach_m: Final[Any]
    rod_wave_transits: Final[Any]
    shore_hardness_HSC: Final[Any]
    shot_mass_kg: Final[Any]
    sliding_regime: Final[Any]
    sphere_compliance: Final[Any]
    sphere_mass_kg: Final[Any]
    static_indentation_m: Final[Any]
    sticking_speed_m_per_s: Final[Any]
    strain_rate_per_s: Final[Any]
    tangential_restitution: Final[Any]
    target_cross_speed_m_per_s: Final[Any]
    target_speed_m_per_s: Final[Any]
    target_spin_about_path_rad_per_s: Final[Any]
    target_spin_rad_per_s: Final[Any]
    target_tangential_speed_m_per_s: Final[Any]
    terminal_speed_m_per_s: Final[Any]
    time_for_coverage_s: Final[Any]
    unloading_exponent: Final[Any]
    unloading_radius_m: Final[Any]
    verlet: Final[Any]
    wave_loss_fraction: Final[Any]
    work: Final[Any]
    yield_force_N: Final[Any]
    yield_indentation_m: Final[Any]
    yield_speed_m_per_s: Final[Any]
    yielding_body: Final[Any]
    zener_number: Final[Any]
    # end of results
    @property
    def trace(self) -> NDArray[np.void]: ...
    @property
    def picture(self) -> bytes: ...
    def to_dict(self) -> dict[str, Any]: ...

def run(
    scenario: str | PathLike[str] | Mapping[str, Any],
    /,
    *,
    set: Mapping[str, Any] | None = None,
    pictures: bool = True,
) -> Outcome: ...
def calibrate(
    scenario: str | PathLike[str] | Mapping[str, Any],
    data: _Columns | None = None,
    /,
    *,
    set: Mapping[str, Any] | None = None,
    pictures: bool = True,
) -> Outcome: ...
def find(
    key: str,
    scenario: str | PathLike[str] | Mapping[str, Any],
    /,
    *,
    between: tuple[float | str | None, float | str | None] | None = None,
    set: Mapping[str, Any] | None = None,
    **result: float | str,
) -> list[dict[str, Any]]: ...
def laws() -> list[dict[str, str]]: ...
def materials() -> list[dict[str, Any]]: ...
def schema() -> dict[str, Any]: ...

# what the other modules use

@final
class Column:
    @property
    def __array_interface__(self) -> dict[str, Any] | None: ...
    def categories(self) -> tuple[list[str], NDArray[np.int32]] | None: ...
    def numpy(self) -> NDArray[Any]: ...

def arrow_stream(columns: list[tuple[str, Column]]) -> object: ...
def table_of_csv(bytes: bytes) -> Table: ...
def numeric_keys() -> list[str]: ...
def validated(contact: Contact, path: str, value: Any) -> float | NDArray[np.float64]: ...
def rows(contact: Contact, keys: list[tuple[str, Any]]) -> dict[str, Column]: ...

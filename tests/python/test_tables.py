"""Tables of impacts: broadcasting, what is refused, and who reads them."""

import faulthandler
import re
import signal
import sys
import threading
import time
from collections.abc import Callable
from multiprocessing import get_context
from pathlib import Path

import numpy as np
import pandas
import plm_impact as plm
import polars
import pyarrow
import pytest
from conftest import ROOT, steel, tables_of_steel


def test_broadcast_keys_give_rows_of_sweep(contact: plm.Contact) -> None:
    speeds, strengths = np.linspace(0.5, 5, 7), np.array([200e6, 345e6, 900e6])
    table = plm.impacts(contact, speed=speeds, yield_strength=strengths[:, None])
    assert table.shape == table["restitution"].shape == (3, 7) and len(table) == 21
    sweep = {"half_space.yield_strength": strengths.tolist(), "impact.speed": speeds.tolist()}
    expected = plm.run(tables_of_steel(sweep=sweep)).tables["table"]
    assert list(table) == list(expected)
    for name in table:
        assert table[name].ravel().tolist() == expected[name].tolist(), name
    # arrays of the same shape are paired row by row
    paired = plm.impacts(contact, speed=speeds[:3], half_space_yield_strength=strengths)
    assert paired["restitution"].tolist() == [table["restitution"][k, k] for k in range(3)]
    # numeric keys in any order, and texts with a unit
    radii = plm.impacts(contact, **{"impact.speed": "3 m/s", "sphere.radius": [1e-3, 5e-3]})
    assert radii["restitution"][1] == contact.restitution(3.0)
    assert plm.impacts(contact, speed=3)["restitution"].shape == ()
    assert plm.impacts(contact, speed=[])["restitution"].shape == (0,)
    misaligned = np.frombuffer(b"." + np.array([3.0]).tobytes(), offset=1)
    assert not misaligned.flags.aligned and contact.restitution(misaligned)[0] == contact.restitution(3.0)
    assert plm.impacts(contact, speed=np.array([3], dtype=">f4"))["restitution"][0] == contact.restitution(3.0)


def test_damped_tables_match_sweep() -> None:
    speeds, fractions = np.linspace(0.5, 5, 9), np.array([0.0, 0.02, 0.3])
    table = plm.impacts(steel(damping=dict(viscous=0.1)), speed=speeds, viscous=fractions[:, None])
    sweep = {"damping.viscous": fractions.tolist(), "impact.speed": speeds.tolist()}
    expected = plm.run(tables_of_steel(sweep=sweep))
    assert table["restitution"].ravel().tolist() == expected.tables["table"]["restitution"].tolist()


@pytest.mark.parametrize(
    ("keys", "error", "text"),
    [
        (dict(speed=[1, 2], yield_strength=[1e8, 2e8, 3e8]), ValueError, "shape mismatch"),
        (dict(speed="-2 m/s"), ValueError, r"impact.speed: .*-2 m/s is not allowed: a speed must be > 0 m/s"),
        (dict(speed=10**400), ValueError, "impact.speed: the whole number is too large"),
        (dict(speed=["1", "2"]), TypeError, "impact.speed: found the type <U1, expected numbers in SI"),
        (dict(speed=[True]), TypeError, "found the type bool"),
        (dict(speed=1j), TypeError, "found the type complex128"),
        (dict(speed=np.ma.masked_array([1.0, 2.0], [True, False])), TypeError, "mask"),
        (dict(speed=[[1, 2], [3]]), ValueError, "inhomogeneous"),
        (dict(speed=object()), TypeError, "found the type object"),
        (dict(speeed=1), ValueError, "`speeed` is not a numeric key"),
        (dict(speed=1, youngs_modulus=1e9), ValueError, "may be sphere_youngs_modulus or half_space_youngs_modulus"),
        (dict(yield_strength=1e9), ValueError, r"\[impact\] is missing"),
        (dict(speed=1, drop_height=1), ValueError, "impact.drop_height: replaces impact.speed"),
        (dict(speed=1, stiffness_ratio=0.5), ValueError, "no case uses this law"),
        (dict(speed=1, law="thornton"), TypeError, "law: words are not broadcast; make a Contact for each"),
        (
            {"speed": [1, 2], "impact.speed": [3, 4]},
            ValueError,
            "impact.speed: is given twice, as speed and as impact.speed",
        ),
        (
            dict(radius=1e-3, sphere_radius=2e-3, speed=1),
            ValueError,
            "sphere.radius: is given twice, as radius and as sphere_radius",
        ),
        ({}, ValueError, "no key is given"),
    ],
)
def test_bad_tables_are_refused(contact: plm.Contact, keys: dict, error: type, text: str) -> None:
    with pytest.raises(error, match=text):
        plm.impacts(contact, **keys)


def test_forbidden_value_fails_only_its_row(contact: plm.Contact) -> None:
    speeds = np.array([1.0, np.nan, 3.0, 0.0, -1.0, np.inf])
    good = [0, 2]
    for damping in ({}, dict(damping=dict(viscous=0.05))):
        one = steel(**damping)
        with pytest.warns(
            plm.ModelWarning,
            match=r"impact.speed at index 1: NaN m/s is not allowed.*\n4 of 6 cases have no result, the first: not_allowed",
        ):
            table = plm.impacts(one, speed=speeds)
        with pytest.warns(
            plm.ModelWarning,
            match=r"impact.speed at index 1: NaN m/s is not allowed.*\n4 of 6 cases have no result, the first: not_allowed",
        ):
            restitution = one.restitution(speeds)
        assert table["status"].tolist() == ["ok", "not_allowed", "ok", "not_allowed", "not_allowed", "not_allowed"]
        assert (
            np.isnan(restitution).tolist()
            == np.isnan(table["restitution"]).tolist()
            == [row not in good for row in range(6)]
        )
        assert (
            table["restitution"][good].tolist() == restitution[good].tolist() == one.restitution(speeds[good]).tolist()
        )
        # the keys are given back as they came
        assert np.array_equal(table["impact_speed_m_per_s"], speeds, equal_nan=True)
    # of two axes, and of numbers that a sampler gives
    with pytest.warns(plm.ModelWarning, match=r"half_space.yield_strength at index \(1, 0\): -1 Pa"):
        table = plm.impacts(contact, speed=[1.0, 2.0], yield_strength=[[3e8], [-1.0]])
    assert np.isnan(table["restitution"]).tolist() == [[False, False], [True, True]]
    with pytest.warns(plm.ModelWarning, match="half_space.yield_strength at index 0: NaN"):
        assert np.isnan(plm.impacts(contact, speed=[1.0, 2.0], yield_strength=np.nan)["restitution"]).all()
    with pytest.warns(plm.ModelWarning, match="impact.speed: -1 m/s is not allowed"):
        assert np.isnan(contact.restitution(-1.0))
    with pytest.raises(ValueError, match="the whole number is too large"):
        contact.restitution(10**400)
    with pytest.raises(ValueError, match="the whole number is too large"):
        contact.force(10**400)


def test_words_share_their_texts(contact: plm.Contact) -> None:
    table = plm.impacts(contact, speed=np.linspace(1, 2, 10_000))
    status = table["status"]
    assert status.dtype == object and status.nbytes == 80_000 and not status.flags.writeable
    assert len({id(word) for word in status}) == 1 and (status == "ok").all()
    frame = table.to_pandas()
    assert isinstance(frame["status"].dtype, pandas.CategoricalDtype) and frame["status"].cat.codes.dtype == np.int8
    assert frame["status"].memory_usage(index=False) < 20_000
    assert isinstance(polars.DataFrame(table)["status"].dtype, (polars.Categorical, polars.Enum))
    # one length of text in a structured array, which can be saved without pickle
    assert table.to_numpy()["status"].dtype.kind == "U"


def test_table_beyond_memory_is_refused(contact: plm.Contact) -> None:
    steps = np.broadcast_to(1.0, (1 << 20, 1 << 20))
    with pytest.raises((MemoryError, ValueError)):
        plm.impacts(contact, speed=steps)
    sweep = {"impact.speed": dict(linspace=[1, 2], points=1 << 60)}
    bodies = dict(youngs_modulus=210e9, poissons_ratio=0.3)
    with pytest.raises(MemoryError, match="does not fit into memory"):
        plm.run(dict(sphere=dict(radius=5e-3, density=7850, **bodies), half_space=bodies, sweep=sweep))


def test_the_help_names_every_column() -> None:
    waves = plm.impacts(
        steel(half_space=dict(yield_strength="345 MPa", density=7850, youngs_modulus=210e9, poissons_ratio=0.3)),
        speed=[1.0],
    )
    named = set(re.findall(r"`(\w+)`", plm.impacts.__doc__))
    assert set(waves) <= named and {"impact_speed_m_per_s", "restitution_with_waves", "dent_diameter_m"} <= set(waves)


def test_rows_have_the_interval_of_e_and_the_speed_of_the_body_that_is_hit() -> None:
    # what a material by name leaves open, as one impact has it
    contact = steel(half_space=dict(material="aluminium-6061-t6"))
    table = plm.impacts(contact, speed=[1.0, 3.0])
    for row, speed in enumerate([1.0, 3.0]):
        low, high = contact.impact(speed).restitution_interval
        assert abs(table["restitution_interval_low"][row] - low) < 1e-10
        assert abs(table["restitution_interval_high"][row] - high) < 1e-10
        assert low < table["restitution"][row] < high
    # a strength that is a number alone says nothing of its error
    strength = steel(half_space=dict(yield_strength="345 MPa", youngs_modulus=210e9, poissons_ratio=0.3))
    assert "restitution_interval_low" not in plm.impacts(strength, speed=1.0)
    # two equal balls: that which is hit moves on at (1 + e)/2 of the speed, by the momentum
    struck = dict(
        radius="5 mm", mass="ball", density=7850, yield_strength="345 MPa", youngs_modulus=210e9, poissons_ratio=0.3
    )
    pair = steel(
        half_space=struck,
        sphere=dict(radius="5 mm", density=7850, yield_strength="345 MPa", youngs_modulus=210e9, poissons_ratio=0.3),
    )
    rows = plm.impacts(pair, speed=[1.0, 3.0])
    moved = 0.5 * (1.0 + rows["restitution"]) * rows["impact_speed_m_per_s"]
    assert np.allclose(rows["target_speed_m_per_s"], moved, rtol=1e-12)
    # half of the dent that stays is the flat of the sphere
    assert np.allclose(rows["flat_depth_m"], 0.5 * rows["residual_indentation_m"], rtol=1e-12)


@pytest.mark.filterwarnings("ignore:at impact.speed:UserWarning")
def test_rows_without_result_are_nan_and_warn() -> None:
    contact = steel(law=dict(stronge={}))
    with pytest.warns(UserWarning, match="cases have no result, the first: outside_law"):
        table = plm.impacts(contact, speed=np.logspace(-4, 3, 50))
    failed = table["status"] == "outside_law"
    assert failed.any() and np.array_equal(np.isnan(table["restitution"]), failed)
    with pytest.warns(UserWarning, match="cases have no result"):
        assert np.array_equal(np.isnan(contact.restitution(table["impact_speed_m_per_s"])), failed)
    assert table.to_arrow()["restitution"].null_count == failed.sum()


def test_call_warns_once_with_own_class() -> None:
    contact = steel(law=dict(stronge={}))
    # from a speed on at which adhesion counts no longer, as that is a warning too
    speeds = np.logspace(-3, 2, 50)
    sweep = {"impact.speed": speeds.tolist()}
    bodies = dict(youngs_modulus=210e9, poissons_ratio=0.3)
    tables = dict(
        sphere=dict(radius=5e-3, density=7850, **bodies),
        half_space=dict(yield_strength=345e6, **bodies),
        law=dict(stronge={}),
    )
    calls = [
        lambda: contact.restitution(speeds),
        lambda: plm.impacts(contact, speed=speeds),
        lambda: plm.run({**tables, "sweep": sweep}),
    ]
    for call in calls:
        with pytest.warns() as caught:
            call()
        (warning,) = caught
        assert warning.category is plm.ModelWarning and issubclass(plm.ModelWarning, UserWarning)
        assert Path(warning.filename).name == Path(__file__).name
        # the limits of the model, and the rows without a result
        first, *_, last = str(warning.message).splitlines()
        assert "at impact.speed = 100 m/s" in first and "cases have no result" in last


@pytest.mark.filterwarnings("ignore::UserWarning")
def test_xarray_dataset_has_keys_as_dimensions(contact: plm.Contact) -> None:
    speeds, strengths = np.linspace(0.001, 5, 3), np.array([2e8, 9e8])
    table = plm.impacts(contact, speed=speeds, yield_strength=strengths[:, None], radius=1e-3)
    data = table.to_xarray()
    assert dict(data.sizes) == {"half_space_yield_strength_Pa": 2, "impact_speed_m_per_s": 3}
    one = data["restitution"].sel(impact_speed_m_per_s=speeds[1], half_space_yield_strength_Pa=9e8)
    assert float(one) == table["restitution"][1, 1] and float(data["sphere_radius_m"]) == 1e-3
    assert np.array_equal(data["dent_diameter_m"], table["dent_diameter_m"], equal_nan=True) and "status" in data
    # two keys along one axis: the first of the registry names it, and the other is a coordinate
    paired = plm.impacts(contact, speed=speeds, yield_strength=[2e8, 3e8, 4e8]).to_xarray()
    assert paired.coords["impact_speed_m_per_s"].dims == ("half_space_yield_strength_Pa",)
    # a key along two axes names none
    both = plm.impacts(contact, speed=np.outer([1.0, 2.0], speeds + 1)).to_xarray()
    assert both["restitution"].dims == both.coords["impact_speed_m_per_s"].dims == ("dim_0", "dim_1")
    assert plm.impacts(contact, speed=3).to_xarray().sizes == {} and plm.impacts(
        contact, speed=[]
    ).to_xarray().sizes == {"impact_speed_m_per_s": 0}
    swept = plm.run(ROOT / "scenarios" / "restitution-vs-speed.toml").tables["table"]
    assert list(swept.to_xarray().sizes.values()) == [len(swept)]


def test_a_package_that_is_missing_is_named(contact: plm.Contact, monkeypatch: pytest.MonkeyPatch) -> None:
    table = plm.impacts(contact, speed=3)
    for name, method in [
        ("pandas", table.to_pandas),
        ("polars", table.to_polars),
        ("pyarrow", table.to_arrow),
        ("xarray", table.to_xarray),
    ]:
        monkeypatch.setitem(sys.modules, name, None)
        with pytest.raises(ImportError, match=f"needs {name}: pip install {name}"):
            method()


@pytest.mark.filterwarnings("ignore::UserWarning")
def test_dataframe_libraries_read_table_in_place(contact: plm.Contact) -> None:
    square = plm.impacts(contact, speed=np.linspace(0.001, 5, 6).reshape(2, 3))
    expected = {name: column.ravel().tolist() for name, column in square.to_dict().items()}
    arrow = square.to_arrow()
    # both use the same memory, and the NumPy array is read-only
    buffer = arrow["restitution"].chunk(0).buffers()[1]
    assert buffer.address == square["restitution"].__array_interface__["data"][0]
    assert not square["restitution"].flags.writeable
    fresh = plm.impacts(contact, speed=np.linspace(0.001, 5, 6))
    rows = [pyarrow.table(arrow).to_pydict(), fresh.to_pandas().to_dict("list"), square.to_pandas().to_dict("list")]
    rows += [polars.DataFrame(one).to_dict(as_series=False) for one in (arrow, fresh, square)]
    rows.append(square.to_polars().to_dict(as_series=False))
    rows.append(pandas.DataFrame(dict(fresh)).to_dict("list"))
    if hasattr(pandas.DataFrame, "from_arrow"):
        rows.append(pandas.DataFrame.from_arrow(fresh).to_dict("list"))
    assert sum(np.isnan(column).any() for column in expected.values() if isinstance(column[0], float)) == 1, (
        "an impact without a dent"
    )
    for other in rows:
        assert list(other) == list(expected)
        for name, column in expected.items():
            if isinstance(column[0], str):
                assert list(other[name]) == column, name
            else:
                assert np.array_equal(np.array(other[name], dtype=float), np.array(column), equal_nan=True), name
    # in place of one column of names
    with pytest.raises(TypeError, match=r"table\.to_pandas"):
        pandas.DataFrame(fresh)
    structured = fresh.to_numpy()
    assert structured.dtype.names == tuple(expected) and structured["restitution"].tolist() == expected["restitution"]


def interrupted(work: Callable[[], object]) -> None:
    """Ctrl-C while the module is at work, from another thread of Python, which goes on meanwhile."""
    # a process that a shell starts in the background ignores Ctrl-C by default
    signal.signal(signal.SIGINT, signal.default_int_handler)
    is_called = threading.Event()

    def interrupt() -> None:
        is_called.wait()
        # the module takes the time of the processor; the main thread waits
        begun = time.process_time()
        while time.process_time() < begun + 0.3:
            time.sleep(0.001)
        signal.raise_signal(signal.SIGINT)

    other = threading.Thread(target=interrupt)
    other.start()
    # what does not hear Ctrl-C, or keeps other threads from running, is ended after minutes
    faulthandler.dump_traceback_later(600, exit=True, file=sys.__stderr__)
    is_called.set()
    with pytest.raises(KeyboardInterrupt):
        work()
    faulthandler.cancel_dump_traceback_later()
    other.join()


@pytest.mark.parametrize("kind", ["impacts", "bounces", "rows", "calibration"])
def test_ctrl_c_stops_work_while_threads_run(kind: str) -> None:
    bodies = dict(youngs_modulus=210e9, poissons_ratio=0.3)
    # the steps take 5 ms for an impact, so that the whole work takes hours
    solver = dict(method="verlet", steps_per_contact=100_000)
    scene = dict(sphere=dict(radius=5e-3, density=7850, **bodies), half_space=bodies, solver=solver)
    speeds = np.linspace(1, 2, 10_000_000)
    contact = steel(solver=solver)
    work = {
        "impacts": lambda: plm.impacts(contact, speed=speeds),
        "bounces": lambda: plm.run(
            {
                **scene,
                "impact": dict(speed=1.0),
                "gravity": dict(acceleration=9.81),
                "repeat": dict(spot="same", impacts=1_000_000),
            }
        ),
        "rows": lambda: plm.run({**scene, "sweep": {"impact.speed": dict(linspace=[1, 2], points=1_000_000)}}),
        "calibration": lambda: plm.calibrate(
            {**scene, "calibrate": dict(noise=dict(restitution=0.01))},
            dict(speed_m_per_s=speeds[::500], restitution=0.6 / speeds[::500] ** 0.25),
        ),
    }
    interrupted(work[kind])
    assert contact.restitution(1.0) < 1


def e_of(speeds: np.ndarray) -> bytes:
    return steel().restitution(speeds).tobytes()


@pytest.mark.filterwarnings("ignore:.*fork:DeprecationWarning")
@pytest.mark.parametrize("start", ["spawn", "fork"])
def test_child_process_has_own_threads(contact: plm.Contact, start: str) -> None:
    speeds = np.linspace(1, 2, 10_000)
    here = contact.restitution(speeds).tobytes()
    with get_context(start).Pool(2) as pool:
        assert pool.map_async(e_of, [speeds] * 3).get(timeout=600) == [here] * 3


def test_oblique_impacts_have_keys_and_results() -> None:
    contact = steel(impact=dict(speed="3 m/s", angle="20 deg"), friction=dict(coefficient=0.15))
    impact = contact.impact()
    assert impact.sliding_regime == "partial" and impact.energy["friction_J"] > 0
    assert set(impact.trace.dtype.names) >= {
        "slip_speed_m_per_s",
        "friction_force_N",
        "tangential_speed_m_per_s",
        "spin_rad_per_s",
    }
    # e is that of the normal speed; the impact is integrated
    assert contact.restitution(3.0) == pytest.approx(steel().restitution(3 * np.cos(np.radians(20))), rel=1e-13)
    assert contact.restitution(3.0) == pytest.approx(impact.restitution, rel=1e-11)
    table = plm.impacts(contact, angle=np.radians([0, 20, 70]), coefficient=[[0.15], [0.3]], spin=0)
    # a row computes friction to 1e-5, a single impact to 1e-7
    assert table["tangential_restitution"][0, 1] == pytest.approx(impact.tangential_restitution, rel=1e-5)
    assert np.isnan(table["tangential_restitution"][:, 0]).all() and table["is_sliding"].tolist()[0] == [0, 0, 1]
    with pytest.raises(ValueError, match=r"requires \[friction\]"):
        steel(impact=dict(speed="3 m/s", angle="20 deg"))

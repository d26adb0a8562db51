"""A contact, its impacts and its force."""

from __future__ import annotations

import base64
import copy
import pickle
import warnings
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from html.parser import HTMLParser
from pathlib import Path
from types import MappingProxyType

import numpy as np
import plm_impact as plm
import pytest
from conftest import ROOT, STEEL, steel


def test_impact_has_results_of_summary(contact: plm.Contact) -> None:
    impact = contact.impact("3 m/s", samples=400)
    outcome = plm.run(ROOT / "scenarios" / "steel-on-steel.toml")
    results = impact.to_dict()
    assert results and all(outcome.summary[name] == value for name, value in results.items() if name != "warnings")
    assert impact.restitution == outcome.summary["restitution"]
    assert impact.energy["balance_error"] == outcome.summary["energy"]["balance_error"]
    assert np.array_equal(impact.trace, outcome.trace)
    assert impact.picture == outcome.pictures["force_indentation"]
    assert {"restitution", "contact_time_s", "trace"} <= set(dir(impact))
    assert "restitution       0.5064" in repr(impact) and "345 MPa" in repr(contact)


def test_trace_is_computed_on_request(contact: plm.Contact) -> None:
    assert len(contact.impact(0.5).trace) >= 400
    assert len(contact.impact(0.5, samples=50).trace) < 70


def test_restitutions_are_those_of_the_table(contact: plm.Contact) -> None:
    speeds = np.logspace(-4, 1.5, 5000)
    table = plm.impacts(contact, speed=speeds)
    assert contact.restitution(speeds).tobytes() == table["restitution"].tobytes()
    # an elastic impact has e = 1; e falls as v^(-1/4) if the contact is fully plastic
    assert table["restitution"][0] == 1.0
    assert contact.restitution(3.0) == contact.restitution("3 m/s") == contact.restitution([3])[0]
    assert contact.restitution(speeds.reshape(50, 100)[::2, ::-1]).shape == (25, 100)
    damped = steel(damping=dict(viscous=0.05))
    assert damped.restitution(speeds).tobytes() == plm.impacts(damped, speed=speeds)["restitution"].tobytes()


def test_contact_may_hold_the_speed() -> None:
    assert steel(impact=dict(speed=2)).impact().restitution == steel().impact(2).restitution
    falling = steel(impact=dict(drop_height="0.1 m"), gravity=dict(acceleration=9.81))
    assert falling.impact().restitution < 1
    with pytest.raises(ValueError, match=r"\[impact\] is missing"):
        steel().impact()


# the laws for which an impact at 1 m/s has a trace without jumps
@pytest.mark.parametrize("law", ["plm", "thornton", "johnson", "stronge", "yigit_christoforou"])
def test_force_function_matches_trace(law: str) -> None:
    contact = steel(law={law: {}})
    trace = contact.impact(1.0, samples=200).trace
    memory = None
    for row in trace:
        force, memory = contact.force([row["indentation_m"]], memory)
        assert abs(force[0] - row["force_N"]) <= 1e-10 * trace["force_N"].max()
    assert memory[0, 0] == trace["indentation_m"].max()


def test_a_memory_is_handed_in_and_out(contact: plm.Contact) -> None:
    deepest = np.geomspace(1e-9, 3e-5, 10_000)
    force, memory = contact.force(deepest)
    assert force.shape == (10_000,) and memory.shape == (10_000, 3)
    assert np.array_equal(memory[:, 0], deepest) and np.array_equal(memory[:, 1], force)
    # below the largest indentation the memory does not change
    for share in (0.0, 0.5, 0.9, 1.0):
        less, same = contact.force(share * deepest, memory)
        assert same.tobytes() == memory.tobytes() and np.all(less <= force * (1 + 1e-15))
    again, _ = contact.force(2 * deepest, memory)
    fresh, _ = contact.force(2 * deepest, np.zeros((10_000, 3)))
    assert again.tobytes() == fresh.tobytes()
    # a memory with few digits, as from a text file, is still valid
    contact.force(deepest, np.array([[float(f"{part:.8g}") for part in row] for row in memory]))
    # an elastic contact has no memory
    elastic = plm.Contact(sphere=dict(radius="5 mm", density=7850, **STEEL), half_space=STEEL)
    assert not elastic.force(deepest)[1].any()


@pytest.mark.parametrize("count", [0, 1, 1000, 1001])
def test_few_contacts_and_many_are_computed_alike(contact: plm.Contact, count: int) -> None:
    """Up to 1000 values are computed in the calling thread, more of them on all cores: the same bits."""
    deepest, speeds = np.linspace(1e-8, 3e-5, 1500), np.linspace(1e-3, 20, 1500)
    force, memory = contact.force(deepest)
    few, memory_of_few = contact.force(deepest[:count])
    assert few.tobytes() == force[:count].tobytes() and memory_of_few.tobytes() == memory[:count].tobytes()
    table, restitution = plm.impacts(contact, speed=speeds), contact.restitution(speeds)
    for name, column in plm.impacts(contact, speed=speeds[:count]).to_dict().items():
        same = table[name][:count]
        assert column.tolist() == same.tolist() if column.dtype == object else column.tobytes() == same.tobytes(), name
    assert contact.restitution(speeds[:count]).tobytes() == restitution[:count].tobytes()


def test_indentations_have_any_shape(contact: plm.Contact) -> None:
    deepest = np.geomspace(1e-8, 3e-5, 6)
    force, memory = contact.force(deepest)
    alone, its_memory = contact.force(deepest[5])
    assert isinstance(alone, float) and alone == force[5] and its_memory.tolist() == memory[5].tolist()
    assert contact.force(0.9 * deepest[5], its_memory)[0] == contact.force(0.9 * deepest, memory)[0][5]
    square, memories = contact.force(deepest.reshape(2, 3))
    assert square.tolist() == force.reshape(2, 3).tolist() and memories.shape == (2, 3, 3)
    assert contact.force(0.9 * deepest.reshape(2, 3), memories)[0].shape == (2, 3)


def program_in_the_help(after: str, before: str) -> str:
    """The program in help(Contact.force) between these words."""
    text = plm.Contact.force.__doc__.split(after)[1].split(before)[0]
    lines = [line for line in text.splitlines() if line.strip()]
    least = min(len(line) - len(line.lstrip()) for line in lines)
    return "\n".join(line[least:] for line in lines)


def test_the_loop_in_the_help_bounces(contact: plm.Contact) -> None:
    """The program in help(Contact.force): each rebound is e of the law under gravity times the impact before it."""
    program = program_in_the_help("again and again:", "Two balls are")
    seen: list[tuple[float, float]] = []
    watched = program.replace("memory[height >= 0]", "watch(height, speed); memory[height >= 0]")
    exec(watched, {"np": np, "contact": contact, "watch": lambda height, speed: seen.append((height[0], speed[0]))})
    height, speed = np.array(seen).T
    into = np.flatnonzero((height[:-1] >= 0) & (height[1:] < 0)) + 1
    out = np.flatnonzero((height[:-1] < 0) & (height[1:] >= 0)) + 1
    restitution = steel(gravity=dict(acceleration=9.81)).restitution(-speed[into])
    assert len(into) >= 4 and restitution.max() < 0.99
    assert np.allclose(speed[out] / -speed[into][: len(out)], restitution[: len(out)], rtol=2e-3)


def two_balls(**keys: object) -> plm.Contact:
    steel = dict(youngs_modulus="210 GPa", poissons_ratio=0.3, density=7850, yield_strength="345 MPa")
    return plm.Contact(sphere=dict(radius=5e-3, **steel), half_space=dict(radius=3e-3, mass="ball", **steel, **keys))


def test_the_loop_of_two_balls_rebounds() -> None:
    """The second program in help(Contact.force), against the closed form: Verlet is of second order."""
    balls = two_balls()
    named = {"balls": balls}
    exec(program_in_the_help("From the first touch to the last:", "An indentation or a memory"), named)
    assert -named["speed"] / 3.0 == pytest.approx(balls.restitution(3.0), abs=1e-5)
    masses = [7850 * 4 / 3 * np.pi * radius**3 for radius in (5e-3, 3e-3)]
    assert balls.mass_kg == pytest.approx(masses[0], rel=1e-14)
    assert balls.reduced_mass_kg == pytest.approx(masses[0] * masses[1] / sum(masses), rel=1e-14)


def test_energy_is_the_work_of_the_force(contact: plm.Contact) -> None:
    path = np.concatenate([np.linspace(0.0, 3e-5, 4001), np.linspace(3e-5, 0.0, 4001)[1:]])
    memory, forces, stored, plastic = None, [], [], []
    for indentation in path.tolist():
        force, memory = contact.force(indentation, memory)
        forces.append(force)
        for energies, energy in zip((stored, plastic), contact.energy(indentation, memory)):
            energies.append(energy)
    # the trapezoidal rule over 4000 steps
    work = np.concatenate([[0.0], np.cumsum(0.5 * np.diff(path) * (np.array(forces)[1:] + forces[:-1]))])
    assert np.abs(np.add(stored, plastic) - work).max() < 1e-5 * work.max()
    assert stored[-1] == 0.0 and plastic[-1] > 0.1 * work.max() and np.all(np.diff(plastic) >= 0.0)
    # all contacts at once
    memories = contact.force(path[1:4000])[1]
    at_once = contact.energy(path[1:4000], memories)
    assert at_once[0].tolist() == stored[1:4000] and at_once[1].tolist() == plastic[1:4000]


def test_header_has_vectors_of_force(contact: plm.Contact) -> None:
    files = contact.header("steel")
    assert sorted(files) == ["plm_steel.h", "plm_steel_test.c", "plm_steel_vectors.csv"]
    assert "plm_steel_force(PLM_REAL indentation" in files["plm_steel.h"]
    rows = [[float(word) for word in line.split(",")] for line in files["plm_steel_vectors.csv"].splitlines()[2:]]
    memory = None
    for row in rows:
        force, memory = contact.force(row[0], memory)
        assert abs(force - row[1]) <= 1e-14 * max(row[1], row[3])
        memory = None if row[0] <= 0.0 else memory
    assert len(rows) == 1000


def test_stiffness_is_the_slope_of_force(contact: plm.Contact) -> None:
    deepest, small = np.array([1e-5, 2e-5, 3e-5]), 1e-10
    _, memory = contact.force(deepest)
    for indentation, of_memory in ((deepest, None), (0.95 * deepest, memory)):
        above, below = (contact.force(indentation + way, of_memory)[0] for way in (small, -small))
        slope = contact.stiffness(indentation, of_memory)
        assert np.allclose(slope, (above - below) / (2 * small), rtol=1e-5)
    assert contact.stiffness(1e-5) == contact.stiffness(deepest)[0]


def test_friction_is_mindlin_and_coulomb(contact: plm.Contact) -> None:
    """Below first yield: 8 G* a times the slip, with Hertz's a, up to the coefficient times the force."""
    indentation, slip = 1e-8, np.array([1e-11, -2e-11, 0.0])
    force, memory = contact.force(indentation)
    friction = contact.friction(0.3, indentation, indentation, memory, slip)
    shear = 1 / (2 * (2 - 0.3) * 2 * (1 + 0.3) / 210e9)
    assert np.allclose(friction, -8 * shear * np.sqrt(5e-3 * indentation) * slip, rtol=1e-12)
    again = contact.friction(0.3, indentation, indentation, memory, slip, friction)
    assert np.allclose(again, 2 * friction, rtol=1e-12)
    many = contact.friction(0.3, [indentation] * 2, [indentation] * 2, [memory] * 2, [slip, 1e6 * slip])
    assert many[0].tolist() == friction.tolist()
    assert np.linalg.norm(many[1]) == pytest.approx(0.3 * force, rel=1e-12)
    for bad, text in (
        ((-0.1, indentation, indentation, memory, slip), "coefficient of 0 or more"),
        ((0.3, indentation, indentation, memory, slip[:2]), "slip: has the shape"),
        ((0.3, [0.0], indentation, memory, slip), "previous_indentation: has the shape"),
    ):
        with pytest.raises(ValueError, match=text):
            contact.friction(*bad)


@pytest.mark.parametrize(
    ("indentation", "memory", "error", "text"),
    [
        ([1e-6], [[1.0, 1.0, 1.0]], ValueError, "contact 0: the memory .* does not belong to this contact"),
        ([1e-6], [[1e-6, np.nan, 0.0]], ValueError, "does not belong to this contact"),
        ([1e-6], np.zeros((2, 3)), ValueError, r"shape \[2, 3\], expected \[1, 3\]"),
        ([1e-6], np.zeros(3), ValueError, r"shape \[3\]"),
        (1e-6, np.zeros((1, 3)), ValueError, r"shape \[1, 3\], expected \[3\]"),
        ([1e-6, np.inf], None, ValueError, "contact 1: an indentation of inf"),
        (["1 um"], None, TypeError, "indentation: found the type"),
    ],
)
def test_a_bad_memory_is_refused(contact, indentation, memory, error, text) -> None:
    with pytest.raises(error, match=text):
        contact.force(indentation, memory)


def test_a_contact_travels_to_other_processes(contact: plm.Contact, tmp_path: Path) -> None:
    for other in (pickle.loads(pickle.dumps(contact)), copy.deepcopy(contact)):
        assert repr(other) == repr(contact) and other.restitution(3.0) == contact.restitution(3.0)


@pytest.mark.filterwarnings("ignore::UserWarning")
def test_results_travel_to_other_processes(contact: plm.Contact) -> None:
    impact = contact.impact(3.0, samples=50)
    other = pickle.loads(pickle.dumps(impact))
    assert other.to_dict() == impact.to_dict() and other.trace.tobytes() == impact.trace.tobytes()
    # NaN, words and a shape of two axes
    table = plm.impacts(steel(law=dict(stronge={})), speed=np.logspace(-4, 3, 50).reshape(5, 10))
    other = pickle.loads(pickle.dumps(table))
    assert list(other) == list(table) and other.shape == (5, 10) and np.isnan(table["restitution"]).any()
    for name in table:
        assert (
            other[name].tolist() == table[name].tolist()
            if table[name].dtype == object
            else other[name].tobytes() == table[name].tobytes()
        ), name
    assert other.to_arrow().equals(table.to_arrow())
    outcome = plm.run(ROOT / "scenarios" / "restitution-vs-speed.toml")
    other = pickle.loads(pickle.dumps(outcome))
    assert other.files == outcome.files and repr(other) == repr(outcome) and other.warnings == outcome.warnings
    assert other.tables["table"]["restitution"].tobytes() == outcome.tables["table"]["restitution"].tobytes()


def test_a_pickle_does_not_warn_again() -> None:
    with pytest.warns(plm.ModelWarning) as caught:
        contact = plm.Contact(sphere=dict(radius="5 mm", density=7850, **STEEL), half_space=STEEL, law="thornton")
    assert len(caught) == 1 and "has no effect" in str(caught[0].message)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert pickle.loads(pickle.dumps(contact)) == contact


def test_a_result_of_tables_alone_is_said_to_be_one(contact: plm.Contact) -> None:
    with pytest.raises(AttributeError, match=r"^plastic_fraction is in tables only\. Use plm_impact\.impacts\.$"):
        _ = contact.impact(3.0).plastic_fraction


def test_computed_results_are_cached(contact: plm.Contact) -> None:
    impact = contact.impact(3.0)
    assert impact.trace is impact.trace and not impact.trace.flags.writeable
    outcome = plm.run(ROOT / "scenarios" / "steel-on-steel.toml", pictures=False)
    assert outcome.tables is outcome.tables and outcome.summary is outcome.summary and outcome.trace is outcome.trace
    small = len(pickle.dumps(plm.run(ROOT / "scenarios" / "steel-on-steel.toml", pictures=False)))
    assert len(pickle.dumps(outcome)) == small
    with pytest.raises(AttributeError):
        plm.impacts(contact, speed=1.0).shape = (2,)


def test_pictures_are_drawn_at_requested_path() -> None:
    path = ROOT / "scenarios" / "steel-on-steel.toml"
    without, drawn = plm.run(path, pictures=False), plm.run(path)
    assert without.pictures == {} and drawn.pictures
    assert {name: file for name, file in drawn.files.items() if name in without.files and name != "summary.json"} == {
        name: file for name, file in without.files.items() if name != "summary.json"
    }
    assert "<img" not in without._repr_html_()
    drops = dict(drop_height_mm=[50, 100, 200], rebound_height_mm=[20.0, 36.0, 65.0])
    scenario = ROOT / "scenarios" / "calibrate-ball-drop.toml"
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        quick, whole = plm.calibrate(scenario, drops, pictures=False), plm.calibrate(scenario, drops)
    assert quick.pictures == {} and whole.pictures and quick.summary["keys"] == whole.summary["keys"]


def test_threads_share_a_contact(contact: plm.Contact) -> None:
    speeds = np.logspace(-3, 1, 20_000)
    alone = contact.restitution(speeds)
    with ThreadPoolExecutor(8) as threads:
        for together in threads.map(lambda _: contact.restitution(speeds), range(32)):
            assert together.tobytes() == alone.tobytes()


def test_keys_of_contact_have_sentences_of_command() -> None:
    with pytest.raises(ValueError, match='unknown unit "mmm" in "5 mmm"; units of a length are nm, '):
        plm.Contact(sphere=dict(radius="5 mmm"), half_space={})
    with pytest.raises(ValueError, match=r"impact\.speed: -1 m/s is not allowed: a speed must be > 0 m/s"):
        steel().impact(-1)
    with pytest.raises(ValueError, match="did you mean `half_space`"):
        plm.Contact(sphere={}, halfspace={})
    with pytest.raises(ValueError, match="tables of one impact"):
        steel(sweep={"impact.speed": [1.0, 2.0]})
    with pytest.raises(TypeError, match=r"impact\.speed: found .*list.*, expected one number .*impacts take arrays"):
        steel().impact([1, 2])
    with pytest.raises(ValueError, match="samples: -1 is not allowed"):
        steel().impact(1.0, samples=-1)
    with pytest.raises(AttributeError, match='no result "peak_force", did you mean "peak_force_N"'):
        _ = steel().impact(1.0).peak_force


def test_contacts_with_equal_input_are_equal(contact: plm.Contact) -> None:
    same = steel(sphere=dict(radius=5e-3, density="7.85 g/cm^3", **STEEL))
    assert contact == same and hash(contact) == hash(same) and len({contact, same}) == 1
    assert contact == pickle.loads(pickle.dumps(contact)) and contact != "a contact"
    for other in (
        steel(law="thornton"),
        steel(impact=dict(speed=1)),
        steel(sphere=dict(radius="6 mm", density=7850, **STEEL)),
    ):
        assert contact != other
    # the results of the summary that depend on the contact alone
    summary = contact.impact(3.0).to_dict()
    for name in ("yield_speed_m_per_s", "yield_indentation_m", "yield_force_N"):
        assert getattr(contact, name) == summary[name]
    elastic = plm.Contact(sphere=dict(radius="5 mm", density=7850, **STEEL), half_space=STEEL)
    assert elastic.yield_speed_m_per_s is None and elastic.yield_force_N is None


def test_a_scalar_of_numpy_is_a_number(contact: plm.Contact) -> None:
    assert type(contact.restitution(np.float64(3))) is float and contact.restitution(
        np.float64(3)
    ) == contact.restitution(3.0)
    # a number with a unit of its own is none
    with pytest.raises(TypeError, match="the value has units"):
        contact.restitution(Quantity(3))


class Shown(HTMLParser):
    """What a notebook shows: the texts, how often each tag opens, and the pictures. Tags have to be closed."""

    def __init__(self, html: str) -> None:
        super().__init__()
        self.text, self.tags, self.pictures, self.open = "", Counter[str](), [], []
        self.feed(html)
        assert not self.open

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags[tag] += 1
        if tag == "img":
            self.pictures.append(base64.b64decode(dict(attrs)["src"].removeprefix("data:image/png;base64,")))
        else:
            self.open.append(tag)

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag

    def handle_data(self, data: str) -> None:
        self.text += data


@pytest.mark.filterwarnings("ignore::UserWarning")
def test_a_notebook_shows_numbers_and_picture(contact: plm.Contact) -> None:
    impact, outcome = contact.impact(3.0), plm.run(ROOT / "scenarios" / "steel-on-steel.toml")
    for thing, picture in [(impact, impact.picture), (outcome, outcome.pictures["force_indentation"]), (contact, None)]:
        shown = Shown(thing._repr_html_())
        assert shown.text == repr(thing) and shown.pictures == ([picture] if picture else [])
    table = plm.impacts(contact, speed=np.linspace(0.001, 5, 30))
    shown = Shown(table._repr_html_())
    # a head, five rows, a row that stands for the others, five rows
    assert shown.tags["tr"] == 12 and shown.tags["th"] == len(list(table)) + 1
    assert all(name in shown.text for name in table) and f"{table['restitution'][29]:.6g}" in shown.text
    assert Shown(plm.impacts(contact, speed=3)._repr_html_()).tags["tr"] == 2


def test_law_may_be_name_tables_any_mapping() -> None:
    thornton = steel(law="thornton")
    assert thornton.restitution(3.0) == steel(law=MappingProxyType(dict(thornton={}))).restitution(3.0)
    assert thornton.restitution(3.0) != steel().restitution(3.0)
    with pytest.raises(ValueError, match="unknown law `thorton`, did you mean `thornton`"):
        steel(law="thorton")
    tables = MappingProxyType(
        dict(sphere=dict(radius="5 mm", density=7850, **STEEL), half_space=dict(yield_strength="345 MPa", **STEEL))
    )
    outcome = plm.run(tables, set=MappingProxyType({"impact.speed": 3, "law": "thornton"}))
    assert outcome.summary["restitution"] == thornton.impact(3.0).restitution


class Quantity(float):
    units = "cm"


@pytest.mark.parametrize(
    "radius",
    [None, object(), [], {}, True, "rigid", "", "\0", "5 mm\n[impact]", 1j, b"5 mm", float("nan"), 10**30, Quantity(5)],
)
def test_hostile_values_are_refused_without_a_panic(radius: object) -> None:
    with pytest.raises((ValueError, TypeError)):
        plm.Contact(sphere=dict(radius=radius, density=7850, **STEEL), half_space=STEEL)


def test_hostile_tables_are_refused_without_a_panic() -> None:
    endless: dict[str, object] = {}
    endless["law"] = endless
    for tables in (
        endless,
        {"a\n[b]": 1},
        {'"': {'"': "'''"}},
        {"": {"": ""}},
        {1: 2},
        {"sphere": {"\ud800": 1}},
        {"sphere": {"radius": "\ud800"}},
    ):
        with pytest.raises((ValueError, TypeError)):
            plm.run(tables)
    for error in (ValueError, FileNotFoundError, plm.ScenarioNotFoundError):
        with pytest.raises(error, match=r"^\[Errno 2\] No such file or directory: 'no-such-file.toml'$") as caught:
            plm.run("no-such-file.toml")
    assert (
        caught.value.filename == "no-such-file.toml"
        and pickle.loads(pickle.dumps(caught.value)).errno == caught.value.errno
    )
    for samples in (0, 1, 10**7, -1, 2**70):
        with pytest.raises(ValueError, match="samples: "):
            steel().impact(1.0, samples=samples)
    with pytest.raises(TypeError):
        steel().impact(1.0, samples=2.5)

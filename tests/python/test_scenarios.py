"""A scenario of every kind gives the numbers and the pictures of the command, bit by bit."""

import csv
import json
import re
import subprocess
from pathlib import Path

import numpy as np
import pandas
import plm_impact as plm
import polars
import pyarrow
import pytest
from conftest import ROOT, tables_of_steel


def of_every_kind() -> list[Path]:
    """Scenarios that have all tables together, none of which has only tables that others before it have; and that of all laws."""
    known, chosen = set(), [ROOT / "scenarios" / "restitution-of-all-laws.toml"]
    for path in sorted((ROOT / "scenarios").glob("*.toml")):
        tables = set(re.findall(r"^\[(\w+)", path.read_text(), re.M))
        if tables - known:
            chosen.append(path)
        known |= tables
    return chosen


SCENARIOS = of_every_kind()


def read(path: Path) -> dict[str, list[str]]:
    with path.open(newline="") as file:
        head, *rows = csv.reader(file)
    return {name: [row[place] for row in rows] for place, name in enumerate(head)}


def same(column: np.ndarray, written: list[str]) -> None:
    if column.dtype.kind == "f":
        expected = np.array([float(field) if field else np.nan for field in written])
        assert column.tobytes() == expected.tobytes()
    else:
        assert column.tolist() == written


# what depends on the folder of the results and on the pictures that were asked for
OF_THE_RUN = {"command", "files", "scenario_path"}


def without_command(summary: dict) -> dict:
    """A summary without the command line that made it, and what follows from it."""
    inner = {name: without_command(value) if isinstance(value, dict) else value for name, value in summary.items()}
    return {name: value for name, value in inner.items() if name not in OF_THE_RUN}


# the command draws the pictures of these, so that they are compared; drawing is what takes most of the time
DRAWN = {"steel-on-steel", "ball-on-ball", "bouncing-clicks"}


@pytest.mark.filterwarnings("ignore::UserWarning")
@pytest.mark.parametrize("path", SCENARIOS, ids=lambda path: path.stem)
def test_scenario_results_match_output_of_command(path: Path, command: Path, tmp_path: Path) -> None:
    pictures = "png" if path.stem in DRAWN else "none"
    arguments = ["run", path, "--out", tmp_path, "--quiet", "--pictures", pictures]
    subprocess.run([command, *arguments], check=True, stderr=subprocess.DEVNULL)
    outcome = plm.run(path)
    written = {file.name: file.read_bytes() for file in tmp_path.iterdir() if not file.name.startswith(".")}
    table = written.pop("table.csv", None)
    drawn = {name for name in outcome.files if name.endswith(".png")} - written.keys()
    assert outcome.files.keys() - drawn == written.keys() and bool(drawn) == (pictures == "none")
    for name, theirs in written.items():
        made = outcome.files[name]
        if name == "summary.json":
            assert without_command(json.loads(made)) == without_command(json.loads(theirs))
        else:
            assert made == theirs, name
    if table is not None:
        columns = read(tmp_path / "table.csv")
        assert columns.pop("case") == [str(case) for case in range(len(outcome.tables["table"]))]
        assert list(columns) == list(outcome.tables["table"])
        for name, fields in columns.items():
            same(outcome.tables["table"][name], fields)
    for name, made in outcome.tables.items():
        if name != "table":
            for column, fields in read(tmp_path / f"{name}.csv").items():
                same(made[column], fields)


def test_there_are_scenarios_of_every_kind() -> None:
    assert len(SCENARIOS) >= 8 and {path.stem for path in SCENARIOS} > DRAWN


def test_dict_is_read_like_file() -> None:
    path = ROOT / "scenarios" / "steel-on-steel.toml"
    tables = dict(
        sphere=dict(radius="5 mm", youngs_modulus="210 GPa", poissons_ratio=0.3, density="7850 kg/m^3"),
        half_space=dict(
            youngs_modulus="210 GPa", poissons_ratio=np.float64(0.3), yield_strength="345 MPa", strength_kind="flow"
        ),
        impact=dict(speed=np.int64(3)),
        law=dict(plm=dict(unloading_exponent="pressure-shape")),
    )
    made, read = plm.run(tables), plm.run(path)
    assert made.files["trace.csv"] == read.files["trace.csv"]
    assert plm.run(tables, set={"impact.speed": "1 m/s"}).summary["restitution"] > made.summary["restitution"]


def test_axes_of_dict_multiply_in_its_order() -> None:
    sweep = {"impact.speed": dict(linspace=[1.0, 2.0], points=2), "half_space.yield_strength": [3e8, 4e8, 5e8]}
    steel = dict(youngs_modulus=210e9, poissons_ratio=0.3)
    tables = dict(sphere=dict(radius=5e-3, density=7850, **steel), half_space=steel, sweep=sweep)
    table = plm.run(tables).tables["table"]
    assert table["impact_speed_m_per_s"].tolist() == [1.0, 1.0, 1.0, 2.0, 2.0, 2.0]


def test_laws_and_schema_match_command(command: Path) -> None:
    schema = subprocess.run([command, "schema"], check=True, capture_output=True).stdout
    assert plm.schema() == json.loads(schema)
    text = subprocess.run([command, "laws"], check=True, capture_output=True, text=True).stdout
    assert {"plm", "thornton"} <= {law["name"] for law in plm.laws()}
    assert all(part in text for law in plm.laws() for part in law.values())
    version = subprocess.run([command, "--version"], check=True, capture_output=True, text=True).stdout
    assert version.split()[1] == plm.__version__


def strength_of(found: plm.Outcome) -> float:
    """The strength in calibrated.toml [MPa]."""
    (number,) = re.findall(r'yield_strength = "(\S+) MPa"', found.files["calibrated.toml"].decode())
    return float(number)


def test_measurements_may_be_arrays(contact: plm.Contact) -> None:
    # the data are computed with the strength that has to be found
    speeds = np.linspace(0.5, 3, 12)
    steel = dict(youngs_modulus=210e9, poissons_ratio=0.3)
    tables = tables_of_steel(half_space=steel, calibrate=dict(noise=dict(restitution=1e-3)))
    data = dict(speed_m_per_s=speeds, restitution=contact.restitution(speeds))
    found = plm.calibrate(tables, data)
    assert abs(strength_of(found) / 345 - 1) < 1e-4
    # a NaN is a field without a measurement
    times = plm.impacts(contact, speed=speeds)["contact_time_s"].copy()
    data["restitution"] = np.where(speeds > 2, np.nan, data["restitution"])
    times[speeds < 1] = np.nan
    tables["calibrate"] = dict(noise=dict(restitution=1e-3, contact_time=1e-7))
    found = plm.calibrate(tables, {**data, "contact_time_s": times})
    assert abs(strength_of(found) / 345 - 1) < 1e-4


def frames(columns: dict[str, np.ndarray]) -> list[object]:
    """The same columns as a dict, and as the frames that hold measurements."""
    return [columns, pandas.DataFrame(columns), polars.DataFrame(columns, nan_to_null=True), pyarrow.table(columns)]


@pytest.mark.filterwarnings("error")
def test_measurements_of_frame_match_file(contact: plm.Contact, tmp_path: Path) -> None:
    path = ROOT / "scenarios" / "calibrate-ball-drop.toml"
    names, *rows = [
        line.split(",")
        for line in (ROOT / "scenarios" / "drops.csv").read_text().splitlines()
        if not line.startswith("#")
    ]
    columns = {
        name: np.array([float(field or "nan") for field in column])
        for name, column in zip(names, zip(*rows))
        if name != "note"
    }
    of_file = plm.run(path)
    with_text = {**columns, "note": np.array(["as dropped"] * len(rows))}
    for data in [*frames(columns), *frames(with_text)]:
        found = plm.calibrate(path, data)
        assert found.files["calibrated.toml"] == of_file.files["calibrated.toml"]


@pytest.mark.parametrize(
    ("data", "words"),
    [
        (dict(speed=[1.0], restitution=[0.5]), "^data: the column `speed` has no unit"),
        (dict(drop_height_mm=[50.0, 100.0, -3.0], restitution=[0.6, 0.5, 0.5]), "^data, element 2: .*-3"),
        (dict(drop_height_mm=[50.0, 100.0], restitution=["0.6", "much"]), "^data, element 1: .*much"),
        ({}, "data: "),
    ],
)
def test_bad_measurements_are_named_by_position(data: dict, words: str) -> None:
    path = ROOT / "scenarios" / "calibrate-ball-drop.toml"
    for frame in frames(data) if data else [data]:
        with pytest.raises(ValueError, match=words):
            plm.calibrate(path, frame)


def test_masked_and_missing_columns_are_refused() -> None:
    path = ROOT / "scenarios" / "calibrate-ball-drop.toml"
    masked = np.ma.masked_array([0.5, 0.6], [True, False])
    for data in (dict(speed_m_per_s=[1.0, 2.0], restitution=masked), [1.0, 2.0]):
        with pytest.raises(TypeError):
            plm.calibrate(path, data)


def test_warning_points_at_line_of_caller(contact: plm.Contact) -> None:
    # one value for two keys that cannot be told apart
    data = dict(drop_height_mm=[50.0, 100.0, 200.0], restitution=[0.61, 0.52, 0.48])
    free = {
        "half_space.yield_strength": {"from": 1e8, "to": 1e9},
        "half_space.youngs_modulus": {"from": 1e11, "to": 4e11},
    }
    with pytest.warns(plm.ModelWarning) as caught:
        plm.calibrate(ROOT / "scenarios" / "calibrate-ball-drop.toml", data, set={"calibrate.free": free})
    assert {Path(warning.filename).name for warning in caught} == {Path(__file__).name}


def test_materials_are_those_of_the_command(command: Path) -> None:
    listed = subprocess.run([command, "materials"], check=True, capture_output=True, text=True).stdout
    materials = plm.materials()
    assert len(materials) >= 30 and all(entry["name"] in listed for entry in materials)
    # density of steel: EN 1991-1-1 gives 77 to 78.5 kN/m^3
    steel = next(entry for entry in materials if entry["name"] == "steel-s235")
    assert 7700 < steel["properties"]["density_kg_per_m3"]["value"] < 8000
    assert len(steel["properties"]["density_kg_per_m3"]["sources"]) >= 2


def test_find_gives_the_solutions_of_the_command(command: Path, tmp_path: Path) -> None:
    path = ROOT / "scenarios" / "steel-on-steel.toml"
    question = ["find", "impact.drop_height", path, "--dent-diameter", "1 mm"]
    ends = ["--from", "1 cm", "--to", "5 m", "--json"]
    printed = subprocess.run([command, *question, *ends], check=True, capture_output=True, cwd=tmp_path).stdout
    found = plm.find("impact.drop_height", path, dent_diameter="1 mm", between=("1 cm", 5.0))
    assert found == json.loads(printed)["solutions"] and len(found) == 1
    # a dict, a number in SI, the name with its unit, and another key
    tables = tables_of_steel(impact=dict(speed=1.0))
    [faster] = plm.find("impact.speed", tables, dent_diameter_m=1e-3, set={"sphere.radius": "5 mm"})
    speed = (2 * 9.80665 * found[0]["impact_drop_height_m"]) ** 0.5
    assert faster["impact_speed_m_per_s"] == pytest.approx(speed, rel=1e-7)
    with pytest.raises(ValueError, match=r"gives restitution = 0.99.* In this range restitution is .*between"):
        plm.find("impact.speed", path, restitution=0.99, between=(1, 2))
    with pytest.raises(ValueError, match=r"`dent` is not a result of an impact"):
        plm.find("impact.speed", path, dent=1)
    with pytest.raises(TypeError, match=r"one result"):
        plm.find("impact.speed", path)

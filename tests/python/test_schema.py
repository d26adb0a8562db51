"""The schema, by the validator of another project: it takes what the program takes, and refuses what it refuses."""

import json
import subprocess
import sys
from pathlib import Path

import jsonschema
import pytest
from conftest import ROOT

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

SCENARIOS = sorted((ROOT / "scenarios").glob("*.toml"))
KINDS = ["impact", "sweep", "monte_carlo", "indentation", "repeat", "calibrate"]
STEEL = """
[sphere]
radius = "5 mm"
youngs_modulus = "210 GPa"
poissons_ratio = 0.3
density = "7850 kg/m^3"
[half_space]
youngs_modulus = "210 GPa"
poissons_ratio = 0.3
yield_strength = "345 MPa"
[impact]
speed = "3 m/s"
"""


@pytest.fixture(scope="module")
def validator(command: Path) -> jsonschema.protocols.Validator:
    schema = json.loads(subprocess.run([command, "schema"], check=True, capture_output=True).stdout)
    kind = jsonschema.validators.validator_for(schema)
    kind.check_schema(schema)
    return kind(schema)


@pytest.mark.parametrize("path", SCENARIOS, ids=lambda path: path.stem)
def test_repository_scenarios_match_schema(path: Path, validator: jsonschema.protocols.Validator) -> None:
    assert not [error.message for error in validator.iter_errors(tomllib.loads(path.read_text()))]


@pytest.mark.parametrize("kind", KINDS)
def test_templates_of_init_match_schema(kind: str, command: Path, validator: jsonschema.protocols.Validator) -> None:
    written = subprocess.run([command, "init", kind, "--out", "-"], check=True, capture_output=True, text=True).stdout
    # with all lines that can be put in, which stand there as comments without a blank
    lines = [line.lstrip("#") for line in written.splitlines() if not line.startswith("# ")]
    for text in [written, "\n".join(lines)]:
        assert not [error.message for error in validator.iter_errors(tomllib.loads(text))], text


@pytest.mark.parametrize(
    "wrong",
    [
        'radius = "5 mm" -> raduis = "5 mm"',
        'radius = "5 mm" -> radius = -5',
        'radius = "5 mm" -> radius = true',
        'radius = "5 mm" -> radius = "5 kg"',
        'radius = "5 mm" -> radius = "5kg"',
        'radius = "5 mm" -> radius = "5 mm"\ndiameter = "10 mm"',
        'speed = "3 m/s" -> speed = "3 m"',
        'speed = "3 m/s" -> ',
        '[impact]\nspeed = "3 m/s" -> ',
        "poissons_ratio = 0.3 -> poissons_ratio = 0.5",
        "[impact] -> [impakt]",
        "[impact] -> [law.plm]\n[law.hertz]\n[impact]",
        "[impact] -> [law.pml]\n[impact]",
        "[impact] -> [law.plm]\nunloading_exponent = 1\n[impact]",
        "[impact] -> [law.hertz]\nx = 1\n[impact]",
        '[impact] -> [solver]\nmethod = "rk7"\n[impact]',
        "[impact] -> [output]\nsamples = 1\n[impact]",
        '[impact] -> [sweep]\n"impact.sped" = [1]\n[impact]',
        '[impact] -> [sweep]\n"impact.speed" = { linspace = [1, 2] }\n[impact]',
        '[impact] -> [monte_carlo]\n"impact.speed" = { uniform = [1, 2] }\n[impact]',
        '[impact] -> [repeat]\nspot = "some"\n[impact]',
        "[impact] -> [indentation]\nsteps = [{ lode = 1 }]\n[impact]",
    ],
)
def test_program_refuses_what_schema_refuses(
    wrong: str, command: Path, validator: jsonschema.protocols.Validator, tmp_path: Path
) -> None:
    old, new = wrong.split(" -> ")
    assert old in STEEL and validator.is_valid(tomllib.loads(STEEL))
    text = STEEL.replace(old, new, 1)
    assert not validator.is_valid(tomllib.loads(text))
    (tmp_path / "wrong.toml").write_text(text)
    assert subprocess.run([command, "check", tmp_path / "wrong.toml"], capture_output=True).returncode == 2


@pytest.mark.parametrize(
    "right",
    [
        'radius = "5 mm" -> radius = "0.5 cm"',
        'radius = "5 mm" -> radius = 5e-3',
        '"7850 kg/m^3" -> "7.85 g/cm\u00b3"',
        '"345 MPa" -> "345 N/mm^2"',
        'speed = "3 m/s" -> speed = "300 cm/s"',
        'radius = "5 mm" -> radius = "1/2 in"',
        'radius = "5 mm" -> radius = "1 inch"',
        '[impact]\nspeed = "3 m/s" -> [air]\ndensity = 1.2\ndrag = "sphere"\nviscosity = "1.8e-5 Pa s"\n[impact]\ndrop_height = 1',
        '[impact]\nspeed = "3 m/s" -> [air]\ndensity = 1.2\ndrag = "sphere"\nviscosity = "1.8e-5 Pa·s"\n[impact]\ndrop_height = 1',
        'youngs_modulus = "210 GPa" -> youngs_modulus = "rigid"',
        'speed = "3 m/s" -> [sweep]\n"impact.speed" = ["1 m/s", 2]',
        '[impact]\nspeed = "3 m/s" -> [calibrate]\ndata = "drops.csv"\nfree = {}',
    ],
)
def test_program_accepts_what_schema_accepts(
    right: str, command: Path, validator: jsonschema.protocols.Validator, tmp_path: Path
) -> None:
    old, new = right.split(" -> ")
    text = STEEL.replace(old, new, 1)
    assert old in STEEL and validator.is_valid(tomllib.loads(text))
    (tmp_path / "right.toml").write_text(text)
    (tmp_path / "drops.csv").write_text("impact_speed_m_per_s,restitution\n1,0.6\n2,0.5\n")
    assert subprocess.run([command, "check", tmp_path / "right.toml"], capture_output=True).returncode == 0


def test_examples_of_schema_match_their_pattern(validator: jsonschema.protocols.Validator) -> None:
    forms = [
        form for quantity in validator.schema["$defs"].values() for form in quantity["anyOf"] if "examples" in form
    ]
    examples = [(form, example) for form in forms for example in form["examples"] if example]
    assert len(examples) > 30
    for form, example in examples:
        assert validator.evolve(schema=form).is_valid(example), example

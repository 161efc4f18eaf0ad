"""docs/schemas: what plumbline writes as JSON is as its schema says, and each key of it is described there; nothing is
described that is not written."""
import copy
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

try:
    import jsonschema
except ModuleNotFoundError as missing:
    print(f"this test is skipped: {missing} (scripts/setup --dev)")
    sys.exit(77)

import outputs

ROOT = pathlib.Path(__file__).resolve().parents[2]
FOLDER = ROOT / "docs/schemas"
ENDING = ".schema.json"
SCHEMAS = {path.name: json.loads(path.read_text()) for path in sorted(FOLDER.glob("*.json"))}
PARTS = "shared"  # no output is of this kind
# Null, but in no output that is quickly made: the condition number of a singular pose, an effect that was not predicted
# from runs left out, the exponent of a function that is no power, a correlation of what is known exactly, a zero where
# the machine cannot stand.
SELDOM_NULL = {
    ("check-1", "/properties/findings/items/properties/value"),
    ("check-1", "/properties/findings/items/properties/by_how_much"),
    ("diagnosis-1", "/properties/effects/items/properties/left_out_nats"),
    ("diagnosis-1", "/properties/functions/items/properties/exponent"),
    ("identification-1", "/properties/stages/items/properties/correlations/items/items"),
    (PARTS, "/$defs/expected/properties/touched_off"),
}
OF_THE_LIBRARY = {"simulation-1", "error-1", "new-model-1"}
LIBRARY = os.environ.get("PLUMBLINE_LIBRARY")


def validator(name):
    resolver = jsonschema.RefResolver(name, SCHEMAS[name], store=SCHEMAS)
    return jsonschema.Draft202012Validator(SCHEMAS[name], resolver=resolver)


def located(name, pointer=""):
    """The schema at a place of a file."""
    found = SCHEMAS[name]
    for step in pointer.split("/")[1:]:
        found = found[int(step)] if isinstance(found, list) else found[step]
    return found


def referred(name, reference):
    file, _, pointer = reference.partition("#")
    return file or name, pointer


class Walk:
    """Goes through outputs beside their schemas. A place is a file of these and a pointer into it."""

    def __init__(self):
        self.nameless = []
        self.visits = {}  # of each place that describes an object
        self.seen = {}    # of each key that it describes
        self.null = {}    # of each place: whether something there was null, was not

    def go(self, value, place, where):
        named = self.keys(value, place, where)
        if isinstance(value, dict):
            self.nameless += [f"{where}.{key}" for key in value if key not in named]

    def keys(self, value, place, where):
        """The keys of an object that the schema at a place names; what they hold is walked through."""
        name, pointer = place
        schema = located(name, pointer)
        self.null.setdefault(place, set()).add(value is None)
        named = set()
        if "$ref" in schema:
            named |= self.keys(value, referred(name, schema["$ref"]), where)
        for i, branch in enumerate(schema.get("anyOf", [])):
            if validator(name).evolve(schema=branch).is_valid(value):
                named |= self.keys(value, (name, f"{pointer}/anyOf/{i}"), where)
        if isinstance(value, dict):
            named |= self.keys_here(value, place, schema, where)
        if isinstance(value, list) and "items" in schema:
            for i, item in enumerate(value):
                self.go(item, (name, f"{pointer}/items"), f"{where}[{i}]")
        return named

    def keys_here(self, value, place, schema, where):
        name, pointer = place
        properties = schema.get("properties", {})
        if properties:
            self.visits[place] = self.visits.get(place, 0) + 1
        named = set()
        for key, part in value.items():
            if key in properties:
                self.seen[place, key] = self.seen.get((place, key), 0) + 1
                self.go(part, (name, f"{pointer}/properties/{key}"), f"{where}.{key}")
            elif "additionalProperties" in schema:
                self.go(part, (name, f"{pointer}/additionalProperties"), f"{where}.{key}")
            else:
                continue
            named.add(key)
        return named


def places(name, schema=None, pointer=""):
    """Each schema within a file."""
    schema = SCHEMAS[name] if schema is None else schema
    yield pointer, schema
    for word in ("properties", "$defs"):
        for key, part in schema.get(word, {}).items():
            yield from places(name, part, f"{pointer}/{word}/{key}")
    for word in ("items", "additionalProperties"):
        if word in schema:
            yield from places(name, schema[word], f"{pointer}/{word}")
    for i, part in enumerate(schema.get("anyOf", [])):
        yield from places(name, part, f"{pointer}/anyOf/{i}")


def spots(value, path=()):
    """The path to each part of an output; of a list to its first item alone."""
    yield path
    parts = value.items() if isinstance(value, dict) else enumerate(value[:1]) if isinstance(value, list) else ()
    for key, part in parts:
        yield from spots(part, (*path, key))


def part_of(value, path):
    for key in path:
        value = value[key]
    return value


def of_another_type(value):
    if isinstance(value, dict):
        return []
    if isinstance(value, list):
        return {}
    return 12345.5 if isinstance(value, (str, bool)) else "12345.5"


class Schemas(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with tempfile.TemporaryDirectory() as folder:
            made = outputs.Folder(folder)
            outputs.of_programs(made)
            outputs.of_measurements(made)
            if LIBRARY:
                outputs.of_the_library(made, LIBRARY)
            else:
                print("this part is skipped: a library with sanitizers cannot be loaded here")
        cls.outputs = made.outputs
        cls.names = {name.removesuffix(ENDING) for name in SCHEMAS} - {PARTS} - (set() if LIBRARY else OF_THE_LIBRARY)
        cls.walk = Walk()
        for schema, what, value in cls.outputs:
            cls.walk.go(value, (schema + ENDING, ""), f"{schema} of {what}: ")

    def test_each_schema_is_one_and_describes_each_key(self):
        for name, schema in SCHEMAS.items():
            with self.subTest(name):
                jsonschema.Draft202012Validator.check_schema(schema)
                self.assertEqual(schema["$id"], name)
                self.assertTrue(schema["title"] and schema["description"])
                for pointer, part in places(name):
                    if "$ref" in part:
                        target = located(*referred(name, part["$ref"]))
                    if re.search(r"/properties/[^/]+$", pointer):
                        self.assertIn("description", part if "$ref" not in part else {**target, **part}, f"{name}#{pointer}")

    def test_each_output_is_as_its_schema_says(self):
        validators = {name: validator(name) for name in SCHEMAS}
        wrong = [f"{schema} of {what}: {error.json_path}: {error.message}" for schema, what, value in self.outputs
                 for error in validators[schema + ENDING].iter_errors(value)]
        self.assertEqual(wrong, [])

    def test_each_key_of_an_output_is_described(self):
        self.assertEqual(self.walk.nameless, [])

    def test_each_key_that_is_described_is_written_and_what_is_always_written_is_required(self):
        unseen, loose = [], []
        for name in SCHEMAS:
            if name.removesuffix(ENDING) not in {*self.names, PARTS}:
                continue
            for pointer, part in places(name):
                for key in part.get("properties", {}):
                    seen = self.walk.seen.get(((name, pointer), key))
                    if not seen:
                        unseen.append(f"{name}#{pointer}: {key}")
                    elif key not in part.get("required", []) and seen == self.walk.visits[name, pointer]:
                        loose.append(f"{name}#{pointer}: {key}")
        self.assertEqual((unseen, loose), ([], []))

    def test_what_may_be_null_is_so_in_some_output_and_not_in_others(self):
        wrong = []
        for name in SCHEMAS:
            for pointer, part in places(name):
                may_be = "null" in list(part.get("type", ())) or {"type": "null"} in part.get("anyOf", ())
                if may_be and self.walk.null.get((name, pointer)) != {True, False}:
                    wrong.append((name.removesuffix(ENDING), pointer))
        library = [place for place in wrong if place[0] in OF_THE_LIBRARY and not LIBRARY]
        self.assertEqual(set(wrong) - set(library), SELDOM_NULL)

    def test_each_schema_is_used_and_stands_in_the_table(self):
        self.assertEqual({schema for schema, _, _ in self.outputs}, self.names)
        page = (ROOT / "docs/formats.md").read_text()
        self.assertEqual(set(re.findall(r"\]\(schemas/([^)]+)\)", page)), {*SCHEMAS})

    def test_what_is_broken_is_refused(self):
        for schema in sorted(self.names):
            value = max((one.value for one in self.outputs if one.schema == schema), key=lambda one: len(json.dumps(one)))
            checks = validator(schema + ENDING)
            taken = changed = 0
            for path in spots(value):
                was = part_of(value, path)
                if was is None or "parameters" in path or "standard_errors" in path:
                    continue
                broken = copy.deepcopy({"": value})
                part_of(broken, ("", *path)[:-1])[("", *path)[-1]] = of_another_type(was)
                self.assertFalse(checks.is_valid(broken[""]), f"{schema}: {path} of another type")
                changed += 1
                for key in was if isinstance(was, dict) else ():
                    broken = copy.deepcopy(value)
                    del part_of(broken, path)[key]
                    taken += not checks.is_valid(broken)
            self.assertGreater(min(taken, changed), 2, schema)

    def test_the_kinds_of_faults_are_those_of_the_program(self):
        names = re.search(r"kNames\{(.*?)\}", (ROOT / "src/inspect/fault.cpp").read_text(), re.DOTALL)[1]
        kinds = located("inspection-1" + ENDING, "/$defs/kind")["enum"]
        self.assertEqual(kinds, re.findall(r'"(.*?)"', names))
        self.assertGreater(len(kinds), 20)

    def test_the_line_of_the_page_validates(self):
        line = re.search(r"^ {4}(jsonschema .*)$", (ROOT / "docs/formats.md").read_text(), re.MULTILINE)[1]
        program, *words = line.replace("/usr/local/share/plumbline", str(ROOT / "docs")).split()
        checked = next(one.value for one in self.outputs if one.schema == "check-1")
        for value, code in ((checked, 0), ({"plumbline": "check 1"}, 1)):
            with tempfile.TemporaryDirectory() as folder:
                (pathlib.Path(folder) / "check.json").write_text(json.dumps(value))
                done = subprocess.run([sys.executable, "-W", "ignore", "-m", program, *words], cwd=folder,
                                      capture_output=True, text=True)
                self.assertEqual(done.returncode, code, done.stderr)


if __name__ == "__main__":
    unittest.main()

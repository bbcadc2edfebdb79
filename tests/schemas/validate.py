"""Checks scenes and ray trees against the project's JSON Schemas.

    validate.py [--expect-invalid] SCHEMA_FOLDER FILE...

The kind of a file is what its `format` says. One line is printed for each bad file: its name, the
JSON pointer of the worst mistake, and the mistake. The exit code is 1 if any file is bad.

With --expect-invalid each FILE must be bad, and at the place that `places.txt` beside it gives, a
line for each file: its name and the JSON pointer. The lines printed are then the files that are not.
"""

import argparse
import functools
import json
import pathlib
import sys
import textwrap
import urllib.parse

import jsonschema


def join_references(base, reference):
    """urllib knows no fragments of a URN: it drops the URN from `URN` + `#fragment`."""
    if reference.startswith("#"):
        return urllib.parse.urldefrag(base).url + reference
    return urllib.parse.urljoin(base, reference)


def load_validators(folder):
    """A validator for each format, which may refer to the other schemas of the folder."""
    schemas = [json.loads(path.read_text()) for path in sorted(folder.glob("*.schema.json"))]
    store = {schema["$id"]: schema for schema in schemas}
    validators = {}
    for schema in schemas:
        jsonschema.Draft202012Validator.check_schema(schema)
        resolver = jsonschema.RefResolver(
            schema["$id"], schema, store, urljoin_cache=functools.cache(join_references)
        )
        file_format = schema["properties"]["format"]["const"]
        validators[file_format] = jsonschema.Draft202012Validator(schema, resolver=resolver)
    return validators


def reject_duplicates(pairs):
    keys = [key for key, _ in pairs]
    for key in keys:
        if keys.count(key) > 1:
            raise ValueError(f"the key {key!r} is there more than once")
    return dict(pairs)


def reject_constant(word):
    raise ValueError(f"{word} is not a number in JSON")


def pointer(error):
    escaped = [str(part).replace("~", "~0").replace("/", "~1") for part in error.absolute_path]
    return "".join("/" + part for part in escaped)


def find_mistake(path, validators):
    """The worst mistake in the file as (JSON pointer, message); None where it is valid."""
    try:
        document = json.loads(
            path.read_text(encoding="utf-8"),
            object_pairs_hook=reject_duplicates,
            parse_constant=reject_constant,
        )
    except (OSError, ValueError, RecursionError) as problem:
        return "", str(problem)
    if not isinstance(document, dict):
        return "", "not a JSON object"
    validator = validators.get(document.get("format"))
    if validator is None:
        return "/format", f"{document.get('format')!r} is none of {sorted(validators)}"
    error = jsonschema.exceptions.best_match(validator.iter_errors(document))
    return error and (pointer(error), textwrap.shorten(error.message, 200))


def expected_place(path):
    """The JSON pointer that `places.txt` beside the file gives for it."""
    for line in (path.parent / "places.txt").read_text().splitlines():
        name, _, place = line.partition(" ")
        if name == path.name:
            return place.strip()
    raise SystemExit(f"{path}: not in places.txt")


def complaint_about(path, validators, expect_invalid):
    """What to print about the file; None where it is as it should be."""
    mistake = find_mistake(path, validators)
    if not expect_invalid:
        return mistake and f"{path}: {mistake[0] or '(whole file)'}: {mistake[1]}"
    place = expected_place(path)
    if mistake is None:
        return f"{path}: {place}: valid, but should not be"
    if mistake[0] != place:
        return f"{path}: {place}: the mistake was found elsewhere, at {mistake[0]}: {mistake[1]}"
    return None


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--expect-invalid", action="store_true", help="each file must be bad")
    parser.add_argument("schema_folder", type=pathlib.Path)
    parser.add_argument("files", type=pathlib.Path, nargs="+")
    arguments = parser.parse_args()
    validators = load_validators(arguments.schema_folder)
    complaints = [
        complaint
        for path in arguments.files
        if (complaint := complaint_about(path, validators, arguments.expect_invalid))
    ]
    print("\n".join(complaints or [f"{len(arguments.files)} files are as they should be"]))
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())

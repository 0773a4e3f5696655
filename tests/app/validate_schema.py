#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Holds YAML files against a JSON Schema with a validator that is not ours.

    validate_schema.py SCHEMA FILE...

Prints the names of the files that do not fit. Ends with 1 when there are any, with 77 when the
validator is not installed.
"""
import json
import sys

try:
    import jsonschema
    import yaml
except ImportError as missing:
    print(missing)
    sys.exit(77)

with open(sys.argv[1]) as file:
    schema = json.load(file)
jsonschema.Draft202012Validator.check_schema(schema)
validator = jsonschema.Draft202012Validator(schema)
wrong = False
for name in sys.argv[2:]:
    with open(name) as file:
        errors = list(validator.iter_errors(yaml.safe_load(file)))
    for error in errors:
        print(f"{name}: {error.json_path}: {error.message[:200]}")
    wrong = wrong or bool(errors)
sys.exit(1 if wrong else 0)

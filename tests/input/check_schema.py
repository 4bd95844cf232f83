# SPDX-License-Identifier: Apache-2.0
"""Checks TOML files against the JSON schema of scene files, with the keywords of draft 4 that it uses.

check_schema.py SCHEMA FILE...: prints the errors of each file. Exit code 1 if there are any.
"""
import json
import re
import sys
import tomllib

TYPES = {
    'object': lambda v: isinstance(v, dict),
    'array': lambda v: isinstance(v, list),
    'string': lambda v: isinstance(v, str),
    'boolean': lambda v: isinstance(v, bool),
    'integer': lambda v: isinstance(v, int) and not isinstance(v, bool),
    'number': lambda v: isinstance(v, (int, float)) and not isinstance(v, bool),
}
NOTES = {'$schema', 'title', 'description', 'default', 'definitions'}
USED = {'$ref', 'type', 'enum', 'anyOf', 'allOf', 'pattern', 'items', 'minItems', 'maxItems', 'properties'}
USED |= {'additionalProperties', 'minimum', 'maximum', 'exclusiveMinimum', 'exclusiveMaximum'}


class Checker:
    def __init__(self, schema):
        self.root = schema

    def find(self, path):
        at = self.root
        for part in path.lstrip('#/').split('/'):
            at = at[part]
        return at

    def errors(self, value, schema, place):
        if '$ref' in schema:
            return self.errors(value, self.find(schema['$ref']), place)
        unknown = set(schema) - USED - NOTES
        if unknown:
            return [f'{place}: this check knows no keyword {sorted(unknown)}']
        found = []
        types = schema.get('type', list(TYPES))
        if not any(TYPES[t](value) for t in ([types] if isinstance(types, str) else types)):
            return [f'{place}: {value!r} is of another type than {types}']
        if 'enum' in schema and value not in schema['enum']:
            found.append(f'{place}: {value!r} is none of {schema["enum"]}')
        if 'anyOf' in schema and all(self.errors(value, s, place) for s in schema['anyOf']):
            found.append(f'{place}: {value!r} has none of the forms')
        for part in schema.get('allOf', []):
            found += self.errors(value, part, place)
        if isinstance(value, str) and not re.search(schema.get('pattern', ''), value):
            found.append(f'{place}: {value!r} does not match {schema["pattern"]}')
        if TYPES['number'](value):
            found += self.range(value, schema, place)
        if isinstance(value, list):
            if not schema.get('minItems', 0) <= len(value) <= schema.get('maxItems', len(value)):
                found.append(f'{place}: {len(value)} elements')
            for k, element in enumerate(value):
                found += self.errors(element, schema.get('items', {}), f'{place}[{k}]')
        if isinstance(value, dict):
            found += self.keys(value, schema, place)
        return found

    @staticmethod
    def range(value, schema, place):
        low, high = schema.get('minimum', -float('inf')), schema.get('maximum', float('inf'))
        below = value <= low if schema.get('exclusiveMinimum') else value < low
        above = value >= high if schema.get('exclusiveMaximum') else value > high
        return [f'{place}: {value} is out of range'] if below or above else []

    def keys(self, table, schema, place):
        found, properties = [], schema.get('properties', {})
        others = schema.get('additionalProperties', {})
        for key, value in table.items():
            inner = f'{place}.{key}' if place else key
            if key in properties:
                found += self.errors(value, properties[key], inner)
            elif others is False:
                found.append(f'{inner}: unknown key')
            elif isinstance(others, dict):
                found += self.errors(value, others, inner)
        return found


def main(schema, files):
    with open(schema, encoding='utf-8') as file:
        checker = Checker(json.load(file))
    bad = 0
    for name in files:
        with open(name, 'rb') as file:
            errors = checker.errors(tomllib.load(file), checker.root, '')
        bad += bool(errors)
        for error in errors:
            print(f'{name}: {error}')
    return 1 if bad else 0


if __name__ == '__main__':
    sys.exit(main(sys.argv[1], sys.argv[2:]))

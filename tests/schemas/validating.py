"""Documents held against the schemas of the package."""

import functools
import json

from jsonschema import Draft202012Validator
from referencing import Registry, Resource

from allworlds.reports.schemas import schemas

SCHEMAS = schemas()
REGISTRY = Registry().with_resources(
    (schema["$id"], Resource.from_contents(schema)) for schema in SCHEMAS.values()
)


@functools.cache
def validator(reference):
    return Draft202012Validator({"$ref": reference}, registry=REGISTRY)


def complaints(reference, document):
    plain = json.loads(json.dumps(document))
    errors = validator(reference).iter_errors(plain)
    return [f"{error.json_path}: {error.message}" for error in errors]

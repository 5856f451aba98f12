#!/usr/bin/env python3
"""Writes the published JSON Schema and the table of keys in docs/study_file.md from the reader's own table.

    generate.py PROBE            rewrite both
    generate.py PROBE --check    exit 1 where one of them is out of date

PROBE is the test program spec_probe (tests/study), which prints the table of src/study/spec/spec_keys.cpp.
"""
import json
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
SCHEMA = ROOT / "studies/schema/icebow-study-1.schema.json"
DOCS = ROOT / "docs/study_file.md"
BEGIN, END = "<!-- keys: written by studies/schema/generate.py -->", "<!-- end of keys -->"
NAME = "^[A-Za-z0-9\u0080-\U0010ffff][A-Za-z0-9 ._+()\u0080-\U0010ffff-]*$"
RESERVED = "^(baseline|d[0-9]+)$"
EXCLUSIVE = {"hull": [("draft", "waterline_height")], "ice": [("fracture_toughness", "critical_stretch")],
             "solver": [("spacing", "layers"), ("time_step", "time_step_fraction")]}
NEEDS = {"bow": {"ice_knife_angle": "ice_knife_height", "ice_knife_width": "ice_knife_height",
                 "skeg_height": "skeg_length", "skeg_length": "skeg_height", "skeg_angle": "skeg_height",
                 "skeg_width": "skeg_height"}}
# Where a key has one of these values, which others must be given and which must not; "else": where it has not.
CONDITIONS = {"bow": [
    {"key": "angles_at", "is": "quarter_beam", "then": ([], ["flare"]), "else": (["flare"], ["entrance"])},
    {"key": "family", "is": "spoon_reamers", "then": ([], []), "else": ([], ["reamer_step"])},
    {"key": "family", "is": "semi_spoon_chines", "then": ([], []), "else": ([], ["chine"])}],
    "ice": [{"key": "model", "is": "paper", "then": ([], []),
             "else": ([], ["fracture_toughness", "critical_stretch"])}]}
PROGRAM = {"description": "a program that evaluates", "type": "object", "additionalProperties": False,
           "required": ["name", "command"], "properties": {
               "name": {"type": "string", "pattern": "^[A-Za-z0-9_]{1,40}$", "not": {"enum": ["lindqvist", "cycle", "peridynamics"]}},
               "command": {"type": "array", "minItems": 1, "items": {"type": "string"},
                           "prefixItems": [{"type": "string", "minLength": 1}]},
               "time_limit_s": {"type": "number", "exclusiveMinimum": 0, "maximum": 1e8}}}
RESULT = "^/(hull/margins|hydrostatics|lindqvist|cycle|metrics|programs)/."
RANKED_BY = ["mean_load", "mean_load_per_beam", "cycle_load", "lindqvist_breaking"]
SHIPS = ["bow", "hull"]  # one of them; a design may swap them
SECTIONS = ["bow", "hold", "hull", "ice", "water", "sheet", "operation", "solver", "cycle", "output", "confirm", "decide", "ranking", "execution"]
LEARNING = ["initial", "batch", "least_gain", "prior"]  # keys of the algorithm expected_improvement alone
METHOD_KEYS = {"list": [], "grid": ["variables"], "one_at_a_time": ["variables"],
               "latin_hypercube": ["variables", "samples", "seed", "extends", "replace_infeasible"],
               "sobol": ["variables", "samples", "replace_infeasible"],
               "halton": ["variables", "samples", "replace_infeasible"], "morris": ["variables", "samples", "seed"],
               "central_composite": ["variables"], "box_behnken": ["variables"],
               "table": ["file", "columns", "rows"],
               "optimise": ["variables", "algorithm", "max_evaluations", "tolerance", "seed", *LEARNING]}


def rounded(x):
    x = float(f"{x:.12g}")
    return int(x) if x == int(x) and abs(x) < 1e15 else x


def value_schema(key, spelling):
    words = key["meaning"] + (f" [{spelling['unit']}]" if spelling["unit"] else "")
    if key["default"]:
        words += f"; default {key['default']}"
    schema = {"description": words}
    kind = key["type"]
    if kind in ("number", "integer"):
        if spelling["lower"] == spelling["upper"]:
            return {**schema, "const": rounded(spelling["lower"])}
        return {**schema, "type": kind, "minimum": rounded(spelling["lower"]), "maximum": rounded(spelling["upper"])}
    if kind == "choice":
        return {**schema, "enum": key["choices"]}
    return {**schema, "type": {"boolean": "boolean", "text": "string"}[kind]}


def properties(keys, section):
    found = {s["key"]: value_schema(k, s) for k in keys if k["section"] == section for s in k["spellings"]}
    if any(k["scaled"] for k in keys if k["section"] == section):
        found["scale"] = {"description": "scale the values of this section are given at; default full",
                          "enum": ["full", "model"]}
    return found


def any_of(key):
    return {"anyOf": [{"required": [s["key"]]} for s in key["spellings"]]}


def once(key):
    """Exactly one spelling of a required quantity, at most one of another."""
    names = [s["key"] for s in key["spellings"]]
    if key["required"]:
        return [{"oneOf": [{"required": [n]} for n in names]}] if len(names) > 1 else [{"required": names}]
    return [{"not": {"required": [a, b]}} for i, a in enumerate(names) for b in names[i + 1:]]


def condition(mine, rule):
    def branch(required, forbidden):
        return {"allOf": [any_of(mine[k]) for k in required] + [{"not": any_of(mine[k])} for k in forbidden]}
    test = {"properties": {rule["key"]: {"const": rule["is"]}}, "required": [rule["key"]]}
    branches = {word: branch(*rule[word]) for word in ("then", "else") if any(rule[word])}
    return {"if": test, **branches}


def section_schema(keys, section):
    mine = {k["name"]: k for k in keys if k["section"] == section}
    rules = [rule for k in mine.values() for rule in once(k)]
    rules += [{"not": {"allOf": [any_of(mine[a]), any_of(mine[b])]}} for a, b in EXCLUSIVE.get(section, [])]
    rules += [{"if": any_of(mine[a]), "then": any_of(mine[b])} for a, b in NEEDS.get(section, {}).items()]
    rules += [condition(mine, rule) for rule in CONDITIONS.get(section, [])]
    schema = {"type": "object", "additionalProperties": False, "properties": properties(keys, section)}
    return {**schema, "allOf": rules} if rules else schema


def patch_schema(keys, section):
    """A design's change to a section: any of its keys, null drops the file's."""
    optional = section in SHIPS or not any(k["required"] for k in keys if k["section"] == section)
    values = {name: {"anyOf": [{"type": "null"}, {"$ref": f"#/properties/{section}/properties/{name}"}]}
              for name in properties(keys, section)}
    return {"type": ["object", "null"] if optional else "object", "additionalProperties": False, "properties": values}


def designs_schema(table):
    changes = {s: patch_schema(table["keys"], s) for s in table["design_sections"]}
    changes["scale"] = {"anyOf": [{"type": "null"}, {"$ref": "#/properties/scale"}]}
    design = {"type": "object", "additionalProperties": False, "required": ["name"], "properties": {
        "name": {"type": "string", "minLength": 1, "maxLength": 64, "pattern": NAME, "not": {"pattern": RESERVED}},
        "set": {"description": "JSON merge patch (RFC 7386) on this file", "type": "object",
                "additionalProperties": False, "properties": changes}}}
    return {"description": "named designs", "type": "array", "items": design}


def variable_schema(key, spelling):
    limits = {k: v for k, v in value_schema(key, spelling).items() if k != "description"}
    of = {"values": {"type": "array", "minItems": 1, "uniqueItems": True, "items": limits}}
    if key["type"] == "number":
        of.update(min=limits, max=limits, levels={"type": "integer", "minimum": 2, "maximum": 1000})
    return {"type": "object", "additionalProperties": False, "properties": of}


def variables_schema(table):
    numeric = [k for k in table["keys"] if k["type"] in ("number", "integer", "choice")
               and (k["section"] in table["design_sections"] or k["name"] == "scale")]
    pointers = {(f"/{k['section']}" if k["section"] else "") + f"/{s['key']}": variable_schema(k, s)
                for k in numeric for s in k["spellings"]}
    return {"description": "JSON pointer into this file -> range, in the file's unit", "type": "object",
            "minProperties": 1, "additionalProperties": False, "properties": pointers}


def method_rule(kind, all_keys):
    then = {"properties": {k: False for k in all_keys if k not in METHOD_KEYS[kind]}}
    if "variables" in METHOD_KEYS[kind]:
        levels = kind in ("grid", "one_at_a_time")
        ranged = {"required": ["min", "max"] + (["levels"] if levels else []),
                  "properties": {"values": False, **({} if levels else {"levels": False})}}
        listed = {"required": ["values"], "properties": {"min": False, "max": False, "levels": False}}
        listable = levels or kind in ("latin_hypercube", "sobol", "halton")
        each = {"oneOf": [ranged, listed]} if listable else ranged
        then["properties"]["variables"] = {"additionalProperties": each}
        then["required"] = ["variables"]
    test = {"properties": {"type": {"const": kind}}}  # holds without a type as well: the default is a list
    return {"if": test if kind == "list" else {**test, "required": ["type"]}, "then": then}


def method_schema(table):
    schema = section_schema(table["keys"], "method")
    schema["properties"]["algorithm"]["enum"] = [a["name"] for a in table["algorithms"]]
    schema["properties"]["variables"] = variables_schema(table)
    schema["properties"]["columns"] = {"description": "table: pointers into this file", "type": "array", "minItems": 1,
                                       "items": {"type": "string", "pattern": "^/"}}
    schema["properties"]["rows"] = {"description": "table: a number for each column", "type": "array", "minItems": 1,
                                    "maxItems": 100000, "items": {"type": "array", "items": {"type": "number"}}}
    schema["properties"]["extends"] = {"description": "latin_hypercube: smaller numbers of samples that it grew from",
                                       "type": "array", "minItems": 1, "uniqueItems": True,
                                       "items": {"type": "integer", "minimum": 1, "maximum": 99999}}
    keys = [k for k in schema["properties"] if k != "type"]
    schema["allOf"] = [method_rule(kind, keys) for kind in METHOD_KEYS]
    schema["allOf"].append({
        "if": {"properties": {"algorithm": {"const": "expected_improvement"}}, "required": ["algorithm"]},
        "then": {"properties": {"tolerance": False, "max_evaluations": {"maximum": 1000}}},
        "else": {"properties": {key: False for key in LEARNING}}})
    return schema


def make_schema(table):
    keys = table["keys"]
    top = properties(keys, "")
    top.update({s: section_schema(keys, s) for s in SECTIONS})
    top["evaluators"] = {"description": "default lindqvist and peridynamics", "type": "array", "minItems": 1, "uniqueItems": True,
                         "items": {"anyOf": [{"enum": ["lindqvist", "cycle", "peridynamics"]}, PROGRAM]}}
    by = top["ranking"]["properties"]["by"]
    first = {"type": by.pop("type"), "anyOf": [{"enum": RANKED_BY}, {"pattern": "^/.+_N$"}]}
    number = {"type": "string", "anyOf": [{"enum": RANKED_BY}, {"pattern": RESULT}]}
    weighed = {"type": "object", "additionalProperties": False, "required": ["by"], "properties": {
        "by": number, "best": {"description": "default smallest", "enum": ["smallest", "largest"]}}}
    by["anyOf"] = [first, {"type": "array", "minItems": 2, "maxItems": 2,
                           "prefixItems": [first, {"anyOf": [number, weighed]}]}]
    top["designs"] = designs_schema(table)
    top["method"] = method_schema(table)
    derived = [p for p, v in top["method"]["properties"]["variables"]["properties"].items() if "enum" not in json.dumps(v)]
    top["derived"] = {"description": "expressions that replace numbers of this file", "type": "object",
                      "additionalProperties": False,
                      "properties": {p: {"type": "string", "maxLength": 1000} for p in derived if p != "/scale"}}
    top["constraints"] = {"description": "what numbers of each result must keep to", "type": "array", "minItems": 1,
                          "items": {"type": "object", "additionalProperties": False, "required": ["at"],
                                    "anyOf": [{"required": ["min"]}, {"required": ["max"]}], "properties": {
                                        "at": {"description": "pointer into the result", "type": "string", "pattern": RESULT},
                                        "min": {"type": "number"}, "max": {"type": "number"}}}}
    conditions = {s: patch_schema(keys, s) for s in ("ice", "water", "operation")}
    top["scenarios"] = {"description": "conditions that each design is judged over", "type": "array", "minItems": 1,
                        "maxItems": 100, "items": {
                            "type": "object", "additionalProperties": False, "required": ["name", "set"], "properties": {
                                "name": {"type": "string", "minLength": 1, "maxLength": 64, "pattern": NAME},
                                "weight": {"description": "default 1", "type": "number", "exclusiveMinimum": 0, "maximum": 1e6},
                                "set": {"description": "JSON merge patch (RFC 7386) on this file", "type": "object",
                                        "minProperties": 1, "additionalProperties": False, "properties": conditions}}}}
    return {"$schema": "https://json-schema.org/draft/2020-12/schema", "$id": "urn:icebow:study:1",
            "title": "Icebow study file, version 1", "type": "object", "additionalProperties": False,
            "required": ["icebow_study", "ice", "operation"],
            "oneOf": [{"required": [s]} for s in SHIPS], "properties": top}


def pretty(value, indent=""):
    """JSON text with whatever fits on one line on one line."""
    line = json.dumps(value)
    if len(indent) + len(line) <= 110 or not isinstance(value, (dict, list)):
        return line
    inner = indent + " "
    if isinstance(value, dict):
        items = [f"{inner}{json.dumps(k)}: {pretty(v, inner)}" for k, v in value.items()]
        return "{\n" + ",\n".join(items) + "\n" + indent + "}"
    return "[\n" + ",\n".join(inner + pretty(v, inner) for v in value) + "\n" + indent + "]"


def key_table(table):
    lines = [BEGIN, ""]
    for section in ["", "bow", "hold", "hull", "ice", "water", "sheet", "operation", "solver", "cycle", "output", "method", "confirm", "decide", "ranking", "execution"]:
        lines += [f"### {'Top level' if not section else '`' + section + '`'}", "",
                  "| key | allowed | default | meaning |", "|---|---|---|---|"]
        for k in (k for k in table["keys"] if k["section"] == section):
            first = k["spellings"][0]
            allowed = {"choice": ", ".join(f"`{c}`" for c in k["choices"]), "boolean": "`true`, `false`",
                       "text": "text"}.get(k["type"]) or first["range"]
            if k["name"] == "algorithm":
                allowed = "see Methods"
            if (section, k["name"]) == ("ranking", "by"):
                allowed = ", ".join(f"`{c}`" for c in RANKED_BY) + ", or a pointer; or a list of two"
            others = ", ".join(f"`{s['key'][len(k['name']):]}`" for s in k["spellings"][1:])
            lines.append(f"| `{first['key']}`{' (' + others + ')' if others else ''} | {allowed} | "
                         f"{'**required**' if k['required'] else k['default']} | {k['meaning']} |")
        lines.append("")
    return "\n".join(lines + [END])


def main():
    table = json.loads(subprocess.run([sys.argv[1], "--keys"], check=True, capture_output=True, text=True).stdout)
    schema = pretty(make_schema(table)) + "\n"
    docs = DOCS.read_text()
    before, rest = docs.split(BEGIN)
    docs_now = before + key_table(table) + rest.split(END)[1]
    if "--check" in sys.argv:
        stale = [str(p.relative_to(ROOT)) for p, text in ((SCHEMA, schema), (DOCS, docs_now))
                 if not p.exists() or p.read_text() != text]
        if stale:
            sys.exit(f"out of date, run studies/schema/generate.py: {', '.join(stale)}")
        return
    SCHEMA.write_text(schema)
    DOCS.write_text(docs_now)


main()

"""The XML files of a functional mock-up unit: modelDescription, buildDescription, terminalsAndIcons."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from xml.etree import ElementTree
from xml.etree.ElementTree import Element, SubElement

from ...algorithms.response import Response
from ...spec.tendons import tendon_names
from .units import exponents, spelled
from .variables import STEP, Variable, first_references

VERSIONS = {2: "2.0", 3: "3.0"}
CATEGORIES = {2: {"logStatusError": "calls that fail", "logStatusDiscard": "steps and values that are refused"}}
METHODS = "solver.methods"
"""The type of the integrators."""


def model_description(
    answers: Response,
    version: int,
    variables: Sequence[Variable],
    token: str,
    tool: str,
    files: Sequence[str],
    derived: bool,
) -> bytes:
    """``modelDescription.xml``; ``files`` are the C sources, ``derived`` tells whether there are derivatives."""
    name = answers.chain.robot.name
    root = Element("fmiModelDescription", fmiVersion=VERSIONS[version], modelName=name)
    root.set("guid" if version == 2 else "instantiationToken", token)
    root.set("description", f"dynamics of the flexible arm '{name}'")
    root.set("generationTool", tool)
    root.set("variableNamingConvention", "structured")
    if version == 2:
        root.set("numberOfEventIndicators", "0")
    for kind in ("ModelExchange", "CoSimulation"):
        element = SubElement(root, kind, {"modelIdentifier": name} | _abilities(version, kind, derived))
        if version == 2:
            listed = SubElement(element, "SourceFiles")
            for file in files:
                SubElement(listed, "File", name=file)
    _units(SubElement(root, "UnitDefinitions"), [x.unit for x in variables if x.unit])
    _types(SubElement(root, "TypeDefinitions"), version, variables)
    categories = SubElement(root, "LogCategories")
    for category, meaning in CATEGORIES[2].items():
        SubElement(categories, "Category", name=category, description=meaning)
    SubElement(root, "DefaultExperiment", startTime="0", stopTime="1", stepSize=repr(STEP))
    listed = SubElement(root, "ModelVariables")
    for k, variable in enumerate(variables):
        if version == 2 and variable.causality == "independent":
            continue  # optional there, and importers of FMI 2.0 want a start value of it, which the standard forbids
        (_scalar if version == 2 else _typed)(listed, k, variable)
    _structure(SubElement(root, "ModelStructure"), answers, version, variables)
    return _text(root)


def _abilities(version: int, kind: str, derived: bool) -> dict[str, str]:
    if version == 2:
        out = {"canGetAndSetFMUstate": "true", "canSerializeFMUstate": "true"}
        out["providesDirectionalDerivative"] = _flag(derived)
        more = {"ModelExchange": {"completedIntegratorStepNotNeeded": "true"}}
    else:
        out = {"canGetAndSetFMUState": "true", "canSerializeFMUState": "true"}
        out |= {"providesDirectionalDerivatives": _flag(derived), "providesAdjointDerivatives": _flag(derived)}
        more = {"ModelExchange": {"needsCompletedIntegratorStep": "false"}, "CoSimulation": {"hasEventMode": "true"}}
    more.setdefault("CoSimulation", {})["canHandleVariableCommunicationStepSize"] = "true"
    return out | more[kind]


def _flag(value: bool) -> str:
    return "true" if value else "false"


def _units(parent: Element, units: Iterable[str]) -> None:
    for unit in dict.fromkeys(units):
        element = SubElement(parent, "Unit", name=spelled(unit))
        if (found := exponents(unit)) is not None:
            SubElement(element, "BaseUnit", {base: str(n) for base, n in found.items()})


def _types(parent: Element, version: int, variables: Sequence[Variable]) -> None:
    for variable in variables:
        if variable.items:
            if version == 2:
                kind = SubElement(SubElement(parent, "SimpleType", name=METHODS), "Enumeration")
            else:
                kind = SubElement(parent, "EnumerationType", name=METHODS)
            for number, item in enumerate(variable.items, 1):
                SubElement(kind, "Item", name=item, value=str(number))


def _common(reference: int, x: Variable) -> dict[str, str]:
    out = {"name": x.name, "valueReference": str(reference), "description": x.description}
    out |= {"causality": x.causality, "variability": x.variability}
    return out | ({"initial": x.initial} if x.initial else {})


def _numbers(x: Variable) -> dict[str, str]:
    """The attributes of a value in both versions."""
    if x.items:
        return {"declaredType": METHODS, "start": str(x.start)}
    out = {"unit": spelled(x.unit)}
    out |= {"nominal": repr(x.nominal)} if x.nominal else {}
    return out | ({"start": repr(float(x.start))} if x.start is not None else {})


def _scalar(parent: Element, reference: int, x: Variable) -> None:
    """A variable of FMI 2.0, which refers to others by their place from 1: as time is missing, their references."""
    element = SubElement(parent, "ScalarVariable", _common(reference, x))
    value = SubElement(element, "Enumeration" if x.items else "Real", _numbers(x))
    if x.derivative is not None:
        value.set("derivative", str(x.derivative))


def _typed(parent: Element, reference: int, x: Variable) -> None:
    """A variable of FMI 3.0, which refers to others by their value references."""
    element = SubElement(parent, "Enumeration" if x.items else "Float64", _common(reference, x) | _numbers(x))
    if x.derivative is not None:
        element.set("derivative", str(x.derivative))


# ------------------------------------------------------------------------------ structure


def _structure(parent: Element, answers: Response, version: int, variables: Sequence[Variable]) -> None:
    """Outputs, rates of states, and what is unknown at the beginning, with what each depends on."""
    chain, first, depends = answers.chain, first_references(answers, variables), _dependencies(answers, variables)
    outputs = [k for k, x in enumerate(variables) if x.causality == "output"]
    rates = list(range(first["qdot"], first["qdot"] + chain.nq + chain.nvz))
    unknown = sorted([k for k in outputs if variables[k].initial == "calculated"] + rates)
    groups = (("Outputs", "Output", outputs), ("Derivatives", "ContinuousStateDerivative", rates))
    for name, single, places in (*groups, ("InitialUnknowns", "InitialUnknown", unknown)):
        holder = SubElement(parent, name) if version == 2 else parent
        for k in places:
            key = {"index" if version == 2 else "valueReference": str(k)}
            element = SubElement(holder, "Unknown" if version == 2 else single, key)
            if places is not unknown:
                element.set("dependencies", " ".join(str(d) for d in depends[k]))
                element.set("dependenciesKind", " ".join(_kind(variables, k) for _ in depends[k]))


def _kind(variables: Sequence[Variable], k: int) -> str:
    """Whether a dependency is a constant factor: that of a coordinate's rate on the rate alone is."""
    return "constant" if variables[k].causality == "output" and variables[k].initial == "exact" else "dependent"


def _dependencies(answers: Response, variables: Sequence[Variable]) -> dict[int, list[int]]:
    """The value references of states and inputs on which each rate and output depends."""
    first, found = first_references(answers, variables), answers.sparsity()
    out = {k: [k] for k in range(first["q"], first["tau"])}
    for group, rows in found.items():
        out |= {first[group] + k: [first["q"] + n for n in row] for k, row in enumerate(rows)}
    return out


# ------------------------------------------------------------------------------ FMI 3.0 alone


def build_description(name: str, files: Sequence[str]) -> bytes:
    """``sources/buildDescription.xml``."""
    root = Element("fmiBuildDescription", fmiVersion="3.0")
    configuration = SubElement(root, "BuildConfiguration", modelIdentifier=name)
    listed = SubElement(configuration, "SourceFileSet", language="C99")
    for file in files:
        SubElement(listed, "SourceFile", name=file)
    return _text(root)


def terminals(answers: Response, variables: Sequence[Variable]) -> bytes:
    """``terminalsAndIcons/terminalsAndIcons.xml``: a terminal for each joint axis, tendon and tip."""
    root = Element("fmiTerminalsAndIcons", fmiVersion="3.0")
    listed = SubElement(root, "Terminals")
    chain, first = answers.chain, first_references(answers, variables)
    for k in range(chain.n_joints):
        members = {
            "coordinate": first["q"] + chain.axis_places[k],
            "rate": first["v"] + chain.base_v + k,
            "force": first["tau"] + k,
        }
        _terminal(listed, variables[members["coordinate"]].name, {n: variables[r].name for n, r in members.items()})
    known = {x.name for x in variables}
    for tendon in tendon_names(chain.robot):
        own = {what: f"{tendon}.{what}" for what in ("tension", "length", "power")}
        _terminal(listed, tendon, {what: name for what, name in own.items() if name in known})
    for i in chain.lasts:
        link = chain.segments[i].owner
        names = [x.name for x in variables if x.name.startswith((f"{link}.tip.", f"{link}.w_ext."))]
        _terminal(listed, f"{link}.tip", {name.removeprefix(f"{link}.").removeprefix("tip."): name for name in names})
    return _text(root)


def _terminal(parent: Element, name: str, members: Mapping[str, str]) -> None:
    element = SubElement(parent, "Terminal", name=name, matchingRule="bus")
    for member, variable in members.items():
        SubElement(element, "TerminalMemberVariable", variableName=variable, memberName=member, variableKind="signal")


def _text(root: Element) -> bytes:
    ElementTree.indent(root)
    return ElementTree.tostring(root, encoding="UTF-8", xml_declaration=True) + b"\n"

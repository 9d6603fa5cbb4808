"""Writes what sends a contract's functions to a worker, from the contract.

usage: crossings.py CONTRACT FOLDER

FOLDER/functions.hpp lists the functions, for both sides. FOLDER/proxy.cpp is an answer: each
function as a call of the worker. A file that does not change is not written.
"""

import re
import sys
from pathlib import Path
from typing import NamedTuple, Optional

_DECLARATION = re.compile(r"([\w:<>, ]+?)\s+(\w+)\((.*)\)", re.S)


class Function(NamedTuple):
    result: str
    name: str
    parameters: tuple[str, ...]
    """Each as it is declared, with its name, without its default."""


def namespace_and_functions(contract: str) -> tuple[str, list[Function]]:
    """What a contract declares: it is one namespace, and its functions end by a semicolon."""
    text = re.sub(r"//[^\n]*|^#[^\n]*", "", contract, flags=re.M)
    found = re.search(r"namespace ([\w:]+) \{(.*)\}", text, re.S)
    if found is None:
        raise SystemExit("crossings: a contract is one namespace")
    functions = [function for statement in _statements(found[2])
                 if (function := _function(statement)) is not None]
    if not functions:
        raise SystemExit("crossings: the contract declares no function")
    return found[1], functions


def _statements(body: str) -> list[str]:
    """What ends by a semicolon outside of braces; a struct and its fields are one."""
    statements, depth, start = [], 0, 0
    for at, letter in enumerate(body):
        depth += {"{": 1, "}": -1}.get(letter, 0)
        if letter == ";" and depth == 0:
            statements.append(body[start:at].strip())
            start = at + 1
    return statements


def _function(statement: str) -> Optional[Function]:
    found = _DECLARATION.fullmatch(statement)
    if found is None or re.match(r"using|struct|enum|inline|constexpr", statement):
        return None
    parameters = (re.sub(r"\s*=.*", "", one, flags=re.S) for one in _parameters(found[3]))
    return Function(found[1], found[2], tuple(" ".join(one.split()) for one in parameters))


def _parameters(text: str) -> list[str]:
    """Cut at the commas that are in no brackets."""
    parts, depth = [""], 0
    for letter in text:
        depth += {"<": 1, "(": 1, "{": 1, ">": -1, ")": -1, "}": -1}.get(letter, 0)
        if letter == "," and depth == 0:
            parts.append("")
        else:
            parts[-1] += letter
    return [part for part in parts if part.strip()]


def functions_header(contract_name: str, namespace: str, functions: list[Function]) -> str:
    listed = ",\n    ".join(f"&{namespace}::{function.name}" for function in functions)
    return f"""#pragma once

#include "{contract_name}"
#include "contract.hpp"

namespace grading {{

template <std::uint32_t largest_answer>
using ContractOf = Contract<largest_answer,
    {listed}>;

}}  // namespace grading
"""


def proxy(namespace: str, functions: list[Function]) -> str:
    calls = []
    for function in functions:
        names = ", ".join(re.findall(r"(\w+)$", one)[0] for one in function.parameters)
        calls.append(f"{function.result} {function.name}({', '.join(function.parameters)}) {{\n"
                     f"  return remote<&{namespace}::{function.name}>({names});\n}}\n")
    return f"""#include "proxy.hpp"

#include "remote.hpp"

namespace {namespace} {{
namespace {{

template <auto function>
constexpr grading::Remote<grading::LabContract, function> remote;

}}  // namespace

{''.join(calls)}
}}  // namespace {namespace}
"""


def main() -> None:
    contract, folder = (Path(argument) for argument in sys.argv[1:])
    namespace, functions = namespace_and_functions(contract.read_text(encoding="utf-8"))
    folder.mkdir(parents=True, exist_ok=True)
    for name, text in (("functions.hpp", functions_header(contract.name, namespace, functions)),
                       ("proxy.cpp", proxy(namespace, functions))):
        file = folder / name
        if not file.exists() or file.read_text(encoding="utf-8") != text:
            file.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()

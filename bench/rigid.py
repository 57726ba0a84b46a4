"""Other people's articulated-body algorithms for a rigid chain: Pinocchio compiled, Pinocchio on CasADi, urdf2casadi.

Pinocchio and CasADi bring all headers with their wheels, Boost and Eigen included, so that a C++ compiler is enough.
"""

from __future__ import annotations

import hashlib
import importlib.util
import os
import shutil
import subprocess
from pathlib import Path

import robots
from contenders import Library, Missing, casadi_library, written_by_casadi
from native import LEVELS, BenchError, command

HERE = Path(__file__).resolve().parent
DEFINES = (  # as Pinocchio's own CMake package states them
    "-DBOOST_MPL_LIMIT_LIST_SIZE=30",
    "-DBOOST_MPL_LIMIT_VECTOR_SIZE=30",
    "-DBOOST_MPL_CFG_NO_PREPROCESSED_HEADERS",
    "-DBOOST_FUSION_INVOKE_MAX_ARITY=12",
    "-DNDEBUG",
)
SOURCES = ("pinocchio_aba.h", "pinocchio_chain.hpp", "pinocchio_data.hpp")


def folder_of(module: str) -> Path:
    """Where a Python package lies."""
    spec = importlib.util.find_spec(module)
    if spec is None or spec.origin is None:
        raise Missing(f"the Python package '{'pin' if module == 'pinocchio' else module}' is not installed")
    return Path(spec.origin).parent


def toolchain() -> tuple[str, list[str], Path]:
    """The C++ compiler, its flags for Pinocchio's and CasADi's headers, and CasADi's folder."""
    compiler = next((x for x in ("g++", "c++", "clang++") if shutil.which(x)), None)
    if compiler is None:
        raise Missing("there is no C++ compiler")
    casadi = folder_of("casadi")
    prefix = next((p for p in folder_of("pinocchio").parents if (p / "include/pinocchio").is_dir()), None)
    if prefix is None or not (casadi / "include/eigen3").is_dir():
        raise Missing("the wheels of pin and casadi come without headers here")
    places = (prefix / "include", casadi / "include/eigen3", casadi / "include")
    return compiler, ["-std=c++17", "-w", *DEFINES, *(f"-isystem{p}" for p in places)], casadi


def compiled(store: Path, source: str, flags: list[str], compiler: str, suffix: str) -> Path:
    """A C++ source compiled, kept under the name of what went into it: it takes a minute."""
    key = hashlib.sha256(" ".join((compiler, command(compiler, "--version"), *flags)).encode())
    for name in (source, *SOURCES):
        key.update((HERE / name).read_bytes())
    out = store / f"{Path(source).stem}.{key.hexdigest()[:24]}{suffix}"
    if not out.exists():
        store.mkdir(parents=True, exist_ok=True)
        partial = out.with_suffix(f".{os.getpid()}.part")
        try:
            command(compiler, HERE / source, "-o", partial, *flags)
        except BenchError as error:
            raise Missing(f"{source} does not compile: {str(error)[:160]}") from None
        partial.replace(out)
    return out


def pinocchio_library(store: Path, level: str) -> Library:
    """Pinocchio's ABA compiled with the flags of the others."""
    compiler, flags, _ = toolchain()
    flags = ["-c", *LEVELS[level], *flags]
    return Library("pinocchio", {}, (), (), objects=(compiled(store, "pinocchio_aba.cpp", flags, compiler, ".o"),))


def pinocchio_casadi(store: Path, robot) -> Library:
    """The C of Pinocchio's ABA run on casadi::SX for one chain."""
    compiler, flags, casadi = toolchain()
    flags = ["-O0", *flags, f"-L{casadi}", "-lcasadi", f"-Wl,-rpath,{casadi}"]
    program = compiled(store, "pinocchio_casadi.cpp", flags, compiler, "")
    name = f"pinocchio_{robot.name}"
    table = "\n".join(" ".join(map(repr, row)) for row in robots.rigid_joints(robot))
    done = subprocess.run([program, name], input=table, capture_output=True, text=True)
    if done.returncode:
        raise Missing(f"pinocchio_casadi failed: {done.stderr.strip()[:160]}")
    return written_by_casadi(name, done.stdout, int(done.stdout.split()[2]))


def urdf2casadi(robot) -> Library:
    """The C of urdf2casadi's ABA for one chain."""
    folder_of("urdf2casadi")
    import casadi as ca
    from urdf2casadi.urdfparser import URDFparser

    parser = URDFparser()
    parser.from_string(urdf(robot))
    last = f"link{len(robot.links) - 1}"
    f = parser.get_forward_dynamics_aba("base", last, gravity=list(robot.gravity))
    symbols = [ca.SX.sym(name, f.size1_in(i)) for i, name in enumerate(("q", "v", "tau"))]
    return casadi_library(ca.Function(f"urdf2casadi_{robot.name}", symbols, [f(*symbols)]))


def urdf(robot) -> str:
    """The rigid chain as URDF."""
    lines = ['<robot name="chain">', '<link name="base"/>']
    for i, (axis, offset, m, com, *inertia) in enumerate(robots.rigid_joints(robot)):
        parent = f"link{i - 1}" if i else "base"
        moments = " ".join(f'{k}="{x}"' for k, x in zip(("ixx", "iyy", "izz"), inertia, strict=True))
        direction = " ".join("1" if k == axis else "0" for k in range(3))
        lines += [
            f'<link name="link{i}"><inertial><origin xyz="{com} 0 0"/><mass value="{m}"/>',
            f'<inertia {moments} ixy="0" ixz="0" iyz="0"/></inertial></link>',
            f'<joint name="joint{i}" type="revolute"><parent link="{parent}"/><child link="link{i}"/>',
            f'<origin xyz="{offset} 0 0" rpy="0 0 0"/><axis xyz="{direction}"/>',
            '<limit lower="-9" upper="9" effort="1e9" velocity="1e9"/></joint>',
        ]
    return "\n".join([*lines, "</robot>"])

"""Discrete dynamics for acados: a step of ours and its Jacobian in C, without the Hessian that acados would make."""

from __future__ import annotations

import ctypes
import hashlib
import os
import shlex
import subprocess
from pathlib import Path

import casadi as ca

SOURCE = """\
{code}
#include <acados/utils/external_function_generic.h>
#include <blasfeo/include/blasfeo_d_aux.h>

#define NX {nx}
#define NU {nu}

static int called(void **in, void **out, double *p, int with_jacobian)
{{
    const struct blasfeo_dvec_args *x = in[0], *u = in[1], *next = out[0];
    double x_[NX], u_[NU], next_[NX], jacobian[(NU + NX) * NX], w[{work}];
    const double *arg[{arguments}];
    double *res[{results}];
    casadi_int iw[{integers}];
    blasfeo_unpack_dvec(NX, x->x, x->xi, x_, 1);
    blasfeo_unpack_dvec(NU, u->x, u->xi, u_, 1);
    arg[0] = x_;
    arg[1] = u_;
    arg[2] = p;
    res[0] = next_;
    res[1] = jacobian;
    int status = with_jacobian ? {name}_step_jacobian(arg, res, iw, w, 0) : {name}_step(arg, res, iw, w, 0);
    blasfeo_pack_dvec(NX, next_, 1, next->x, next->xi);
    if (with_jacobian) {{
        const struct blasfeo_dmat_args *to = out[1];
        blasfeo_pack_dmat(NU + NX, NX, jacobian, NU + NX, to->A, to->ai, to->aj);
    }}
    return status;
}}

int {name}_disc(void **in, void **out, void *p)
{{
    return called(in, out, p, 0);
}}

int {name}_disc_jac(void **in, void **out, void *p)
{{
    return called(in, out, p, 1);
}}
"""


def discrete(name: str, x: ca.SX, u: ca.SX, p: ca.SX, after: ca.SX) -> str:
    """C source of `<name>_disc` and `<name>_disc_jac`, acados' "generic" functions of the discrete dynamics.

    `after` (nx, 1) is x after the interval. The Jacobian is that of [u; x], transposed, dense, as acados stores it.
    """
    jacobian = ca.densify(ca.jacobian(after, ca.vertcat(u, x)).T)
    step = ca.Function(f"{name}_step", [x, u, p], [ca.densify(after)])
    both = ca.Function(f"{name}_step_jacobian", [x, u, p], [ca.densify(after), jacobian])
    code = ca.CodeGenerator(f"{name}_dynamics", {"casadi_int": "int", "with_header": False})
    for f in (step, both):
        code.add(f)
    sizes = {"arguments": "arg", "results": "res", "integers": "iw", "work": "w"}
    sizes = {k: max(1, *(getattr(f, f"sz_{short}")() for f in (step, both))) for k, short in sizes.items()}
    return SOURCE.format(code=code.dump(), name=name, nx=x.numel(), nu=u.numel(), **sizes)


def loaded(source: str, folder: Path, include: Path, flags: str) -> str:
    """Compile such a source, once, and load it; its digest. The solvers of acados find its functions by their names."""
    key = hashlib.sha256(f"{flags}\n{source}".encode()).hexdigest()[:12]
    library = folder / f"dynamics_{key}.so"
    if not library.is_file():
        code, half = library.with_suffix(".c"), library.with_suffix(f".{os.getpid()}")
        code.write_text(source)
        places = [f"-I{include}", f"-I{include / 'blasfeo' / 'include'}"]
        command = ["cc", "-std=c99", "-fPIC", "-shared", *shlex.split(flags), *places, str(code), "-o", str(half)]
        done = subprocess.run(command, capture_output=True, text=True)
        if done.returncode:
            raise RuntimeError(f"the dynamics cannot be compiled: {done.stderr.strip()}")
        half.rename(library)
    ctypes.CDLL(str(library), ctypes.RTLD_GLOBAL)
    return key

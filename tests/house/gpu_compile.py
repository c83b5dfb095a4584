"""gpu_compile.py - compiles an OpenCL program for two GPUs without having one: clang and libclc make
PTX, of which ptxas makes code for NVIDIA's sm_90, and code for AMD's gfx90a. Gives what each kernel
takes: registers, private and local memory. A GPU's driver has another compiler, so figures of its
own may differ. Says nothing about speed."""
import re
import subprocess
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PTXAS_PACKAGE = "nvidia-cuda-nvcc-cu12==12.9.86"
PTXAS_FOLDER = ROOT / "build" / PTXAS_PACKAGE  # another version goes elsewhere
LIBCLC = Path("/usr/lib/clc")
# Where a device rounds correctly, which both do, the library asks for it.
CLANG = ("clang", "-x", "cl", "-cl-std=CL1.2", "-O3", "-S", "-o", "-", "-D__OPENCL_VERSION__=120",
         "-D", "RSH_WIDTH=1", "-cl-fp32-correctly-rounded-divide-sqrt",
         "-Xclang", "-finclude-default-header", "-Xclang", "-fdeclare-opencl-builtins",
         "-I", str(ROOT / "kernels"), "-I", str(ROOT / "include"))
# ptxas takes PTX for an older processor; this clang knows none as new as sm_90.
NVPTX = ("-target", "nvptx64--nvidiacl", "-Xclang", "-target-cpu", "-Xclang", "sm_70")
AMDGCN = ("-target", "amdgcn--amdhsa", "-mcpu=gfx90a", "-nogpulib")
# What amdgcn's assembly says of a kernel, by our names.
AMD_FIGURES = {"vgpr": "vgpr_count", "sgpr": "sgpr_count", "scratch": "private_segment_fixed_size",
               "spilled_vgpr": "vgpr_spill_count", "spilled_sgpr": "sgpr_spill_count",
               "lds": "group_segment_fixed_size"}


class CannotCompile(Exception):
    pass


def run(command, **options):
    done = subprocess.run(command, capture_output=True, text=True, check=False, **options)
    if done.returncode:
        raise CannotCompile(f"{Path(command[0]).name}: {done.stderr.strip()[:2000]}")
    return done


def ptxas():
    """Its path. Installed where it is missing, by pip, into a virtual environment of its own."""
    def found():
        return [str(path) for path in PTXAS_FOLDER.glob("lib/*/site-packages/nvidia/cuda_nvcc/bin/ptxas")]
    if not found():
        run(["python3", "-m", "venv", str(PTXAS_FOLDER)])
        run([str(PTXAS_FOLDER / "bin" / "pip"), "install", "-q", PTXAS_PACKAGE])
    return found()[0]


def versions():
    """Of whatever the figures depend on."""
    clang = run(["clang", "--version"]).stdout.splitlines()[0]
    libclc = run(["dpkg-query", "-W", "-f=${Package} ${Version}", "libclc-14"]).stdout
    release = re.search(r"V[\d.]+", run([ptxas(), "--version"]).stdout).group()
    return f"{clang}; {libclc}; ptxas {release}"


def assembly(stem, options, target, libclc):
    link = ("-Xclang", "-mlink-builtin-bitcode", "-Xclang", str(LIBCLC / libclc))
    return run([*CLANG, *target, *link, *options, str(ROOT / "kernels" / f"{stem}.cl")]).stdout


def figure(pattern, text):
    found = re.search(pattern, text)
    return int(found.group(1)) if found else 0


def ptxas_figures(said):
    """Of each kernel, from what ptxas -v says. The stack is that of the kernel and what it calls."""
    figures = {}
    for part in re.split(r"(?=Compiling entry function )", said)[1:]:
        own = part[:part.index("Compile time")]
        stack = figure(r"(\d+) bytes stack frame", own)
        figures[re.search(r"'(\w+)'", own).group(1)] = {
            "registers": figure(r"Used (\d+) registers", own),
            "stack": max(stack, figure(r"(\d+) bytes cumulative stack size", own)),
            "spilled": figure(r"(\d+) bytes spill stores", own),
            "shared": figure(r"(\d+) bytes smem", own)}
    return figures


def undefined_functions(text):
    called = set(re.findall(r"\b(\w+)@(?:got)?(?:pc)?rel32@lo", text))
    return sorted(called - set(re.findall(r"^(\w+):", text, re.MULTILINE)))


def amdgcn_figures(text):
    """Of each kernel, from the metadata of the assembly. VGPRs are those of both kinds together."""
    missing = undefined_functions(text)
    if missing:
        raise CannotCompile(f"amdgcn: libclc has no {', '.join(missing)}")
    figures = {}
    for part in re.split(r"^  - \.args:", text[text.index(".amdgpu_metadata"):], flags=re.MULTILINE)[1:]:
        name = re.search(r"^    \.name: +(\w+)", part, re.MULTILINE).group(1)
        figures[name] = {ours: figure(rf"\.{theirs}: +(\d+)", part) for ours, theirs in AMD_FIGURES.items()}
    return figures


def figures_of(stem, options):
    """What each kernel of a program takes on both."""
    ptx = assembly(stem, options, NVPTX, "nvptx64--nvidiacl.bc")
    said = run([ptxas(), "-arch=sm_90", "-v", "-o", "/dev/null", "/dev/stdin"], input=ptx).stderr
    nvidia = ptxas_figures(said)
    amd = amdgcn_figures(assembly(stem, options, AMDGCN, "amdgcn--amdhsa.bc"))
    if nvidia.keys() != amd.keys():
        raise CannotCompile(f"kernels differ: {sorted(nvidia)} for NVIDIA, {sorted(amd)} for AMD")
    return {kernel: {**nvidia[kernel], **amd[kernel]} for kernel in nvidia}

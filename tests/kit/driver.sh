# driver.sh - sourced by device.sh: finds an OpenCL driver and a loader where the system's own loader
# does not, from the system or from the kit. Needs $kit and $work.

# Drivers that come without an .icd file, or whose file is not in the loader's folder.
kDrivers="libnvidia-opencl.so.1 libamdocl64.so libigdrcl.so libintelocl.so libpocl.so.2"
kFolders="/usr/local/nvidia /usr/lib64 /usr/lib/x86_64-linux-gnu /usr/lib/aarch64-linux-gnu /usr/lib/wsl
    /usr/local/cuda /opt/rocm /opt/amdgpu /opt/intel /usr/local/lib"

# A Debian package into a folder, also where there is no dpkg.
unpack_package() {
    if command -v dpkg >/dev/null; then
        dpkg -x "$1" "$2"
    else
        ar p "$1" data.tar.xz | tar -x -J -C "$2"
    fi
}

# All that the kit carries, once, and again when it is another kit.
unpack_kit() {
    packages=$work/packages
    programs=$work/programs
    ! cmp -s "$kit/contents.txt" "$work/contents.txt" || return 0
    rm -rf "$work"
    mkdir -p "$packages" "$programs"
    local package
    for package in "$kit"/packages/*.deb; do
        unpack_package "$package" "$packages" || return 1
    done
    tar -x -z -f "$kit/programs.tar.gz" -C "$programs" || return 1
    cp "$kit/contents.txt" "$work/"
}

is_known_to_loader() { /sbin/ldconfig -p 2>/dev/null | grep "^[[:space:]]*$1 " >/dev/null; }

# The path of a library that the loader of shared libraries does not know.
find_library() {
    local folder
    for folder in $kFolders; do
        [ ! -d "$folder" ] || find -L "$folder" -maxdepth 4 -name "$1" -print -quit 2>/dev/null
    done | head -n 1
}

# .icd files of the system, and one for each driver that these do not name. OCL_ICD_VENDORS of the
# caller stays.
find_drivers() {
    [ -z "${OCL_ICD_VENDORS:-}" ] || return 0
    local name path
    rm -rf "$work/vendors"
    mkdir -p "$work/vendors"
    cp /etc/OpenCL/vendors/*.icd "$work/vendors/" 2>/dev/null
    for name in $kDrivers; do
        if grep -q "$name" "$work"/vendors/*.icd 2>/dev/null && is_known_to_loader "$name"; then continue; fi
        path=$(find_library "$name")
        [ -n "$path" ] || continue
        grep -l -F "$name" "$work"/vendors/*.icd 2>/dev/null | xargs -r rm
        echo "$path" >"$work/vendors/${name%%.so*}.icd"
        LD_LIBRARY_PATH=${LD_LIBRARY_PATH:+$LD_LIBRARY_PATH:}$(dirname "$path")
    done
    export OCL_ICD_VENDORS=$work/vendors OPENCL_VENDOR_PATH=$work/vendors LD_LIBRARY_PATH
}

# The system's loader, else the kit's.
find_loader() {
    loader=$(/sbin/ldconfig -p 2>/dev/null | awk '$1 == "libOpenCL.so.1" { print $NF; exit }')
    [ -z "$loader" ] || return 0
    loader=$(find "$packages" -name libOpenCL.so.1 | head -n 1)
    export LD_LIBRARY_PATH=${LD_LIBRARY_PATH:+$LD_LIBRARY_PATH:}$(dirname "$loader")
}

clinfo_program() { command -v clinfo || echo "$packages/usr/bin/clinfo"; }

# A GPU, unless the caller chose: where PoCL is installed as well it may come first.
prefer_gpu() {
    [ -z "${RSH_DEVICE:-}" ] || return 0
    local name
    name=$("$(clinfo_program)" --raw 2>/dev/null | awk '
        $2 == "CL_DEVICE_NAME" { name = $0; sub(/^.*CL_DEVICE_NAME +/, "", name) }
        $2 == "CL_DEVICE_TYPE" && /CL_DEVICE_TYPE_GPU/ { print name; exit }')
    [ -z "$name" ] || export RSH_DEVICE=$name
}

find_device() {
    unpack_kit && find_drivers && find_loader && prefer_gpu
}

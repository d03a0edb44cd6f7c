#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs packages in a Debian that has nothing else, and uses them; as root:
#   packaging/test_in_bare_root.sh PACKAGES ROOT
# PACKAGES has the .deb files, of this release of Debian; ROOT is made by debootstrap, and made anew where it exists.
set -euo pipefail
packages=$(realpath "$1")
root=$(realpath -m "$2")
here=$(realpath "$(dirname "${BASH_SOURCE[0]}")/..")

say() { printf '==> %s\n' "$*" >&2; }
die() {
  printf 'test_in_bare_root: %s\n' "$*" >&2
  exit 1
}
inside() { chroot "$root" /usr/bin/env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 "$@"; }
install() {
  inside DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends "$@" >>"$log" ||
    die "cannot install $*: $log"
}
# expect FILE...: these are there in /tmp/test, and not empty.
expect() {
  local file
  for file in "$@"; do [[ -s $root/tmp/test/$file ]] || die "$file was not written"; done
}

((EUID == 0)) || die "debootstrap and chroot need root"
# shellcheck disable=SC1091
codename=$(. /etc/os-release && echo "$VERSION_CODENAME")
# shellcheck disable=SC2016  # the dollars are apt's
mirror=$(apt-get indextargets --format '$(REPO_URI) $(CODENAME)' "Created-By: Packages" |
  awk -v release="$codename" '$2 == release { print $1; exit }')
rm -rf "$root"
mkdir -p "$root"
log=$root.log
say "a bare $codename in $root"
debootstrap --variant=minbase "$codename" "$root" ${mirror:+"$mirror"} >"$log"
mkdir "$root/packages" "$root/tmp/test"
cp "$packages"/*.deb "$root/packages/"
cp "$here"/data/worlds/two_rooms.geojson "$root/tmp/test/"
cp -r "$here/tests/consumer" "$root/tmp/consumer"
inside apt-get update -q >>"$log"
cd "$root"
deb() { local file; for file in packages/"$1"_*.deb; do echo "./$file"; done; }

say "the program alone"
install "$(deb roomatlas)"
inside roomatlas --version
libraries=$(inside ldd /usr/bin/roomatlas | wc -l)
say "it is linked with $libraries shared libraries"
((libraries < 40)) || die "40 or more are too many for the base"
inside roomatlas -q simulate /tmp/test/two_rooms.geojson --odometry typical -o /tmp/test/mission
inside roomatlas build /tmp/test/mission/mission.clf -o /tmp/test/base 2>"$root.err" || die "$(cat "$root.err")"
grep -q 'apt-get install roomatlas-pictures' "$root.err" || die "nothing says how to get pictures"
expect base/plan.svg base/report.html base/building.gpkg
[[ ! -e tmp/test/base/plan.pdf ]] || die "a PDF without the plug-in"
code=0
inside roomatlas export /tmp/test/base/building.gpkg -f dxf -o /tmp/test/none 2>"$root.err" || code=$?
[[ $code == 2 ]] || die "exit code $code for a missing plug-in"
grep -q 'apt-get install roomatlas-gdal' "$root.err" || die "nothing says how to get DXF"

say "with the plug-ins"
install "$(deb roomatlas-pictures)" "$(deb roomatlas-gdal)"
inside roomatlas -q export /tmp/test/base/building.gpkg -f svg,pdf,png,dxf -o /tmp/test/more
expect more/plan.pdf more/plan.png more/plan.dxf
cmp tmp/test/base/plan.svg tmp/test/more/plan.svg || die "the drawing hangs on the plug-ins"

say "in Python"
install "$(deb python3-roomatlas)"
inside python3 -c '
import roomatlas
building = roomatlas.build("/tmp/test/mission/mission.clf")
assert len(building.rooms) == 2 and "<svg" in building.plan.svg()
'

say "a fleet of one"
install "$(deb roomatlas-fleet)"
inside roomatlas-fleet --version

say "in a program of its own"
install "$(deb libroomatlas-dev)" cmake g++ make
inside sh -c 'cmake -S /tmp/consumer -B /tmp/consumer/build >/dev/null && cmake --build /tmp/consumer/build >/dev/null &&
  cd /tmp && ./consumer/build/consumer' | grep -qx '12 m2, 2 m' || die "the consumer does not answer"

say "and gone again"
inside DEBIAN_FRONTEND=noninteractive apt-get purge -q -y roomatlas roomatlas-pictures roomatlas-gdal \
  roomatlas-fleet python3-roomatlas libroomatlas-dev >>"$log"
left=$(find usr etc var/lib -path var/lib/apt -prune -o -path var/lib/dpkg -prune -o -name '*roomatlas*' -print)
[[ -z $left ]] || die "left behind: $left"
say "all packages install, work and go in a bare $codename"

#!/bin/bash
# try_package.sh PACKAGE.deb ROOT
#
# Installs the package in a fresh Debian in the folder ROOT, which debootstrap makes (root, network
# and five minutes), with nothing but what the package asks for, and uses it there as a user would.
# Run by hand, after `./dev package`.
set -euo pipefail
package=$(realpath "${1:?name the package}")
root=${2:?name a folder for the fresh Debian}
here=$(realpath "$(dirname "${BASH_SOURCE[0]}")")
source=$(realpath "$here/../..")

inside() { chroot "$root" /usr/bin/env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 "$@"; }
as_user() { inside HOME=/home/user setpriv --reuid user --regid user --clear-groups "$@"; }

if [[ ! -e $root/etc/debian_version ]]; then
  debootstrap --variant=minbase bookworm "$root" "${DEBIAN_MIRROR:-http://deb.debian.org/debian}"
fi
mountpoint -q "$root/proc" || mount -t proc proc "$root/proc"
trap 'umount "$root/proc"' EXIT
install -m 644 "$package" "$root/tmp/tencer.deb"
# man and bash complete with packages of their own; a compiler is not the package's to bring.
inside DEBIAN_FRONTEND=noninteractive sh -c 'apt-get -qq update &&
  apt-get -qq install -y --reinstall /tmp/tencer.deb >/var/log/tencer-install &&
  apt-get -qq install -y --no-install-recommends \
    man-db bash-completion zsh g++ cmake ninja-build pkg-config >>/var/log/tencer-install'
inside id -u user >/dev/null 2>&1 || inside useradd -m user
rm -rf "$root/home/user/try"
install -d "$root/home/user/try"
cp "$here/use_package.sh" "$source/tests/consumers/examples/pipeline.cpp" "$root/home/user/try"
inside chown -R user /home/user/try
as_user bash /home/user/try/use_package.sh
echo "the package is used in $root"

#!/usr/bin/env bash
# The Debian package in a Debian that has nothing else: what it prints is its proof. By hand, as root,
# with debootstrap and network; it takes minutes.
#
#   cmake --build build --target deb && tests/package.sh
#   tests/package.sh FILE.deb
#   FOLDER=DIR tests/package.sh     where the other Debian is made; otherwise in a temporary folder
set -euo pipefail
sources=$(realpath "$(dirname "${BASH_SOURCE[0]}")/..")
package=$(realpath "${1:-$(ls -t "$sources"/build/packages/taskc_*.deb | head -n 1)}")

# Mounts of our own, which end with us.
if [ -z "${TASKC_IS_APART:-}" ]; then
  exec env TASKC_IS_APART=1 unshare --mount --propagation private "$0" "$package"
fi

folder=${FOLDER:-$(mktemp -d)}
root=$folder/debian
finish() {
  umount "$root/proc" "$root/dev" 2>/dev/null || true
  if [ -z "${FOLDER:-}" ]; then rm -rf --one-file-system "$folder"; fi
}
trap finish EXIT

echo "== A Debian 12 with the least that there is"
if [ ! -e "$root.made" ]; then
  rm -rf --one-file-system "$root"
  debootstrap --variant=minbase bookworm "$root" >"$folder/log" || { tail -n 20 "$folder/log"; exit 1; }
  touch "$root.made"
fi
mount -t proc proc "$root/proc"
mount --rbind /dev "$root/dev"
# The way to the archive is this machine's.
cp -L /etc/resolv.conf "$root/etc/"
cp -r /etc/apt/apt.conf.d/. "$root/etc/apt/apt.conf.d/"
cp "$package" "$root/root/taskc.deb"
echo force-unsafe-io >"$root/etc/dpkg/dpkg.cfg.d/unsafe"  # nobody needs it after a power cut

as_root() { chroot "$root" /usr/bin/env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 \
  DEBIAN_FRONTEND=noninteractive http_proxy="${http_proxy:-}" https_proxy="${https_proxy:-}" "$@"; }
# What a user types and sees, in an empty home folder.
user() {
  printf '\n$ %s\n' "$1"
  chroot --userspec=robot "$root" /usr/bin/env -i -C /home/robot PATH=/usr/bin:/bin LC_ALL=C.UTF-8 \
    HOME=/home/robot MANWIDTH=80 MANPAGER=cat bash -euo pipefail -c "$1"
}

echo "== Installs $(basename "$package")"
as_root apt-get update -qq
as_root apt-get install -qq --no-install-recommends /root/taskc.deb man-db bash-completion pkg-config \
  python3-numpy >"$folder/log" 2>&1 || { tail -n 20 "$folder/log"; exit 1; }
as_root dpkg --verify taskc
as_root id robot >/dev/null 2>&1 || as_root useradd robot
as_root rm -rf /home/robot
as_root install -d -o robot -g robot /home/robot

echo "== Uses it"
user 'taskc --version; trainer --version'
user 'cp -r /usr/share/doc/taskc/tasks /usr/share/doc/taskc/examples . && ls tasks'
user 'taskc build tasks/crawling.task -o crawling.so && ls crawling.so'
user 'trainer train tasks/crawling.task --profile fast-tree --episodes 3 --out run'
user 'trainer report run && ls run/report.html'
user 'cd examples/embed_c && cc -std=c11 balance.c -o balance $(pkg-config --cflags --libs taskc) &&
  taskc build balance.task -o balance.so && ./balance balance.so'
user 'python3 -c "import taskc; print(taskc.load(\"examples/embed_c/balance.task\").name)"'
user 'man taskc build | head -n 12'
user 'man trainer-ctl-swap | grep -A 1 SYNOPSIS'
# As bash does it when the tab key is pressed for the first time.
user 'set +eu; source /usr/share/bash-completion/bash_completion; _completion_loader trainer
  COMP_WORDS=(trainer train --robot qua) COMP_CWORD=3; _trainer; echo "${COMPREPLY[@]}"'

echo
echo "== Removes it"
as_root apt-get purge -qq taskc >"$folder/log" 2>&1
rest=$(find "$root/usr" -path '*taskc*' -o -name 'trainer*')
if [ -n "$rest" ]; then echo "error: it left $rest" >&2; exit 1; fi
echo "nothing of it is left"

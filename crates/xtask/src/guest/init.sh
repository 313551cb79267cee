#!/bin/busybox sh
# The first and only program of a guest: loads the kernel's modules, and goes through
# /checks.sh, which says on the console what it found. Lines that begin with CHECK and VERDICT
# are read by `cargo xtask`; everything else is for people.

/bin/busybox --install -s /bin
export PATH=/bin HOME=/tmp XDG_RUNTIME_DIR=/tmp
mount -t proc proc /proc
mount -t sysfs sys /sys
mount -t devtmpfs dev /dev
mkdir -p /dev/pts
mount -t devpts pts /dev/pts
echo 1 >/proc/sys/kernel/printk
# Parameters are several words.
# shellcheck disable=SC2086
while read -r module parameters; do insmod "/modules/$module" $parameters; done </modules/order
cd /tmp || poweroff -f

checks=0
failed=0

uptime() { cut -d ' ' -f 1 /proc/uptime; }

# verdict NAME SENTENCE RESULT DETAIL: RESULT is 0 if the sentence holds.
verdict() {
	checks=$((checks + 1))
	if [ "$3" = 0 ]; then
		echo "CHECK passed  $(uptime) s: $2 ($4)"
	else
		failed=$((failed + 1))
		echo "CHECK FAILED  $(uptime) s: $2 ($4)"
		for file in "$1".*; do
			echo "--- $file" && tail -n 40 "$file"
		done
	fi
}

# within SECONDS COMMAND...: waits until COMMAND succeeds; fails if it does not in time.
within() {
	tries=$(($1 * 5))
	shift
	until "$@" >/dev/null 2>&1; do
		tries=$((tries - 1))
		[ $tries -gt 0 ] || return 1
		sleep 0.2
	done
}

. /checks.sh

echo "VERDICT $failed of $checks checks failed, after $(uptime) s"
poweroff -f

#!/bin/busybox sh
# Makes a system of this machine's files, in which everything that is written stays in memory, and
# becomes its systemd, which judges. What this machine has set up for itself is left out.

/bin/busybox --install -s /bin
export PATH=/bin
mount -t proc proc /proc
mount -t sysfs sys /sys
mount -t devtmpfs dev /dev
echo 1 >/proc/sys/kernel/printk
# Parameters are several words.
# shellcheck disable=SC2086
while read -r module parameters; do insmod "/modules/$module" $parameters; done </modules/order

options=trans=virtio,version=9p2000.L,ro,msize=512000,cache=loose
mount -t 9p -o $options this /this || poweroff -f
mount -t tmpfs -o mode=755 written /written
mkdir /written/files /written/work
mount -t overlay -o lowerdir=/this,upperdir=/written/files,workdir=/written/work over /new ||
	poweroff -f
cd /new || poweroff -f

for folder in tmp var/tmp var/log run; do mount -t tmpfs -o mode=1755 "$folder" "$folder"; done
rm -rf etc/systemd/system etc/fstab usr/sbin/policy-rc.d .dockerenv
mkdir -p etc/systemd/system etc/systemd/system.conf.d guest
# Nothing has to be brought up to date, neither now nor when a package comes.
touch etc/.updated var/.updated
rm -f var/lib/man-db/auto-update
# What only root may read can neither be read nor written, unless root has started the machine: locks
# are made anew, and so are passwords, which nobody needs here.
rm -f etc/.pwd.lock var/lib/dpkg/lock var/lib/dpkg/lock-frontend var/lib/dpkg/triggers/Lock
for names in passwd:shadow:'*:::::::' group:gshadow:'*::'; do
	IFS=: read -r from to rest <<-LINE
		$names
	LINE
	cut -d : -f 1 "etc/$from" | sed "s/\$/:$rest/" >new && rm -f "etc/$to" && mv new "etc/$to"
	chmod 600 "etc/$to"
done
echo guest >etc/hostname
cp /judge.sh /checks.sh /letoff.deb /*.toml guest
mkdir guest/written && mount --move /written guest/written
cat >etc/systemd/system/judge.service <<'UNIT'
[Unit]
DefaultDependencies=no
Requires=sysinit.target
After=sysinit.target

[Service]
Type=oneshot
Environment=guest=/guest PATH=/usr/sbin:/usr/bin:/sbin:/bin
WorkingDirectory=/tmp
ExecStart=/bin/sh /guest/judge.sh
ExecStopPost=/bin/systemctl poweroff -ff
StandardOutput=tty
StandardError=tty
TTYPath=/dev/ttyS0
UNIT

cat >etc/systemd/system/default.target <<'UNIT'
[Unit]
Requires=judge.service
After=judge.service
UNIT
printf '[Manager]\nShowStatus=no\n' >etc/systemd/system.conf.d/guest.conf

umount /proc /sys
mount --move /dev /new/dev
exec switch_root /new /lib/systemd/systemd

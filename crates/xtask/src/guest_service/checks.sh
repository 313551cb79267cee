# Installs the package, lets its service go through what befalls one, and removes it again.

export LETOFF_SOCKET=/run/letoff/letoff.sock
scene=/etc/letoff/scene.toml

show() { systemctl show -P "$1" letoff; }
is() { [ "$(show "$1")" = "$2" ]; }
said() { journalctl --sync && journalctl -u letoff -o cat --no-pager | grep -q "$1"; }

# The service's state, in a line.
state() {
	echo "$(show ActiveState)/$(show SubState), result $(show Result), status" \
		"$(show ExecMainStatus), $(show NRestarts) restarts"
}

# Whether the host plays and can be asked: the socket is its own and there.
plays() { is ActiveState active && [ -S $LETOFF_SOCKET ]; }

start() {
	# Here it is started more often than anything fails.
	systemctl reset-failed letoff 2>/dev/null
	systemctl start letoff 2>start.err
	within 60 plays
}

# is_down RESULT STATUS: whether it is down for this reason, and does not come back.
is_down() {
	within 30 eval 'is SubState dead || is SubState failed' || return 1
	sleep 7
	! plays && is Result "$1" && is ExecMainStatus "$2"
}

# What the package has done.
install() { dpkg --force-unsafe-io -i /guest/letoff.deb >install.out 2>&1; }

# What a person does who wants it to play.
give_scene() { mkdir -p /etc/letoff && cp /guest/scene.toml $scene; }

installed() {
	install && letoff --version >version.out && [ -s /usr/share/man/man1/letoff-run.1.gz ] &&
		! systemctl -q is-enabled letoff && is ActiveState inactive && [ -d /etc/letoff ]
	verdict install "the package is installed, and nothing plays without a scene" $? \
		"$(cat version.out), $(systemctl is-enabled letoff), $(state)"
}

# What links are like, in a line.
links() {
	echo "queue $(cat /sys/class/net/vcan0/tx_queue_len)," \
		"latency timer $(cat /sys/bus/usb-serial/devices/ttyUSB0/latency_timer) ms," \
		"$(stat -c '%G %a' /dev/ttyUSB0)"
}

rules() {
	udevadm settle
	links=$(links)
	[ "$links" = "queue 64, latency timer 1 ms, dialout 660" ] && [ "$links" != "$before" ]
	verdict rules "udev gives CAN a queue and FTDI no delay, as soon as it is installed" $? \
		"$before, then $links"
}

started() {
	give_scene
	start
	heard=$?
	journalctl -u letoff -o cat --no-pager >started.out
	verdict started "it starts" $heard "$(state)"
}

# Who it is, and what it may.
confined() {
	pid=$(show MainPID)
	ids=$(grep -E '^(Uid|Groups|NoNewPrivs|CapEff|CapBnd|Seccomp):' "/proc/$pid/status" | tr '\n\t' '; ')
	uid=$(id -u letoff)
	echo "$ids" >confined.out
	grep -q "Uid: $uid $uid $uid $uid;" confined.out &&
		grep -q "Groups:.* $(getent group audio | cut -d : -f 3) " confined.out &&
		grep -q "Groups:.* $(getent group dialout | cut -d : -f 3) " confined.out &&
		grep -q "NoNewPrivs: 1;" confined.out && grep -q "CapEff: 0*;" confined.out &&
		grep -q "CapBnd: 0*;" confined.out && grep -q "Seccomp: 2;" confined.out &&
		grep -E -q '^[^ ]+ / [^ ]+ ro' "/proc/$pid/mounts"
	verdict confined "the process is the user letoff's, may nothing else, and writes nowhere" $? \
		"$(cat confined.out)"
}

prioritised() {
	chrt -a -p "$(show MainPID)" >prioritised.out
	count=$(grep -c -E 'policy: SCHED_(FIFO|DEADLINE)' prioritised.out)
	locked=$(grep VmLck "/proc/$(show MainPID)/status" | tr -s '\t ' ' ')
	[ "$count" -ge 1 ] && [ "$locked" != "VmLck: 0 kB" ]
	verdict prioritised "the tick has real-time priority, and the memory is locked" $? \
		"$count threads; $locked"
}

logged() {
	said "simulated"
	verdict logged "the journal has what it says" $? \
		"$(journalctl -u letoff -o cat --no-pager | grep -c letoff) lines"
}

# The scene is being edited while the host dies.
killed() {
	before=$(show MainPID)
	echo 'half a sce' >$scene
	kill -KILL "$before"
	within 60 eval "! is MainPID $before && ! is MainPID 0 && plays"
	verdict killed "kill -9: systemd starts it again, with the scene that it played" $? \
		"process $before, then $(show MainPID); $(state)"
	give_scene
}

# A key is held, its note sounds on a cable, and all processes of the unit are killed at once.
all_killed() {
	mkfifo -m 666 /run/cable
	cat /run/cable >cable.out &
	reader=$!
	exec 9>/run/cable
	sed -e 's/spring-wall/grand-springs/' -e 's#"none"#"raw:/run/cable"#' /guest/scene.toml >$scene
	systemctl restart letoff && within 60 plays
	letoff press C4 --force 8 >press.out 2>&1 &
	press=$!
	within 30 sounds 903c
	before=$(show MainPID)
	systemctl kill --kill-whom=all -s KILL letoff
	within 60 eval "! is MainPID $before && ! is MainPID 0 && plays" && within 10 sounds '903c.*803c'
	verdict all_killed "all of it is killed while a note sounds: the next host ends the note" $? \
		"$(od -An -tx1 -v cable.out | tr -d '\n'); $(state)"
	exec 9>&-
	kill $press $reader
	rm /run/cable
	give_scene
	systemctl restart letoff && within 60 plays
	# Here it is started more often than anything fails.
	systemctl reset-failed letoff
}

# Whether these bytes came over the cable.
sounds() { od -An -tx1 -v cable.out | tr -d ' \n' | grep -q "$1"; }

restarted() {
	before=$(show MainPID)
	systemctl restart letoff && within 60 eval "! is MainPID $before && plays"
	verdict restarted "systemctl restart" $? "process $before, then $(show MainPID); $(state)"
}

reloaded() {
	before=$(show MainPID)
	systemctl reload letoff 2>reloaded.err && within 20 eval "is MainPID $before && plays"
	verdict reloaded "systemctl reload keeps the process" $? "process $before; $(state)"
}

# A process that stands still does not feed the watchdog.
hung() {
	before=$(show MainPID)
	kill -STOP "$before"
	within 90 eval "! is MainPID $before && ! is MainPID 0 && plays"
	verdict hung "a host that hangs is ended and started again" $? \
		"process $before, then $(show MainPID); $(state)"
}

upgraded() {
	before=$(show MainPID)
	install && within 60 eval "! is MainPID $before && plays"
	verdict install "an upgrade restarts what plays" $? "process $before, then $(show MainPID); $(state)"
}

stopped_by_command() {
	letoff stop >stop.out 2>&1
	code=$?
	is_down success 0 && [ $code = 0 ]
	verdict stop "letoff stop ends it, and it stays down" $? "exit $code; $(state)"
}

stopped() {
	start
	systemctl stop letoff
	is_down success 0 && [ -z "$(ls -A /run/letoff)" ]
	verdict stopped "systemctl stop ends it in time, by itself" $? "$(state)"
}

# A wrong scene stays wrong: it is not tried again, nor is the one before a crash that nobody waits
# for any more.
wrong_scene() {
	start
	kill -KILL "$(show MainPID)"
	within 5 is SubState auto-restart
	systemctl stop letoff
	echo 'tick_hz = "fast"' >$scene
	systemctl start letoff 2>wrong.err
	is_down exit-code 2 && is NRestarts 0 && said tick_hz
	verdict wrong "a wrong scene: exit code 2, down for good, and the journal says why" $? "$(state)"
	systemctl reset-failed letoff
}

removed() {
	give_scene
	start
	pid=$(show MainPID)
	dpkg -r letoff >removed.out 2>&1 && [ ! -e "/proc/$pid" ] && [ ! -e /usr/bin/letoff ] &&
		[ -e $scene ] && [ -d /var/lib/letoff ] && ! systemctl cat letoff >/dev/null 2>&1 &&
		[ -n "$(left)" ]
	verdict removed "removing ends what plays, and leaves the scene" $? "$(ls /etc/letoff)"
}

# What stands in the guest's memory by this name; packages' own lists have it until a purge.
left() {
	find /guest/written/files /run -path /guest/written/files/guest -prune -o -iname '*letoff*' -print
	grep -l letoff /etc/passwd /etc/group /etc/shadow /etc/gshadow
}

purged() {
	dpkg -P letoff >purged.out 2>&1
	code=$?
	left >>purged.out
	[ $code = 0 ] && [ -z "$(left)" ] && ! dpkg -s letoff >/dev/null 2>&1
	verdict purged "purging leaves nothing" $? "exit $code; $(left | tr '\n' ' ')"
}

# A machine that is set up with its scene first.
prepared() {
	give_scene
	install && systemctl -q is-enabled letoff && within 60 plays
	verdict install "where a scene is waiting, it is enabled and plays" $? "$(state)"
}

# A package of this machine's own is not the one that is tried.
dpkg -P letoff >/dev/null 2>&1
ip link add vcan0 type vcan
udevadm settle
before=$(links)

installed
rules
started
confined
prioritised
logged
killed
all_killed
restarted
[ -z "$(show ExecReload)" ] || reloaded
is WatchdogUSec 0 || hung
upgraded
stopped_by_command
stopped
wrong_scene
removed
purged
prepared
purged

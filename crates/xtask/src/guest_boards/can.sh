# Boards on CAN, and what a bus does to them. Sourced by checks.sh.

# The piece, through sockets.
piece() {
	boards piece --count 8 --on can:vcan0
	play piece --link can:vcan0 --duration 6
	[ $code = 0 ] && holds piece "$complete" && holds piece "$healthy" && bear piece "$fresh"
	verdict piece "a piece is played on eight boards over CAN FD" $? \
		"exit $code; $(notes piece); $(links piece); $(graves piece)"
}

# rate SECONDS: every key of eight boards, a thousand times a second.
rate() {
	boards rate --count 8 --on can:vcan0
	play rate --link can:vcan0 --performance none --duration "$1"
	[ $code = 0 ] && holds rate "$healthy" && bear rate "$fresh and .counts.stale == 0" &&
		holds rate 'all(.boards[]; .samples_hz > 990 and .forces_hz > 990)'
	verdict rate "eight boards of eleven keys at 1 kHz for $1 s" $? \
		"exit $code; $(links rate); $(graves rate)"
}

# disturbed NAME SENTENCE CONDITION TC...: the piece while the queue does something.
disturbed() {
	it=$1
	sentence=$2
	condition=$3
	shift 3
	tc qdisc add dev vcan0 root "$@"
	# They are several words.
	# shellcheck disable=SC2086
	boards "$it" $few
	play "$it" --link can:vcan0 --duration 6
	tc qdisc del dev vcan0 root
	fair "$it" && holds "$it" "$condition" && bear "$it" "$fresh"
	verdict "$it" "$sentence" $? \
		"exit $code; $(notes "$it"); $(links "$it"); $(graves "$it")"
}

missing='([.boards[].missing] | add) > 0'
most='.notes.struck * 2 > .notes.played'

loss() {
	disturbed loss "a tenth of all frames is lost: counted, and played on" \
		"$missing and $most" netem loss 10%
}

# midway NAME SENTENCE CONDITION TC...: the same, from a second after the beginning on.
midway() {
	it=$1
	sentence=$2
	condition=$3
	shift 3
	# They are several words.
	# shellcheck disable=SC2086
	boards "$it" $few
	host "$it" --link can:vcan0 --duration 6
	played 1
	tc qdisc add dev vcan0 root "$@"
	ended
	tc qdisc del dev vcan0 root
	fair "$it" && holds "$it" "$condition" && bear "$it" "$fresh"
	verdict "$it" "$sentence" $? "exit $code; $(links "$it"); $(graves "$it")"
}

# From the beginning, the host would refuse what such delays make unstable.
late() {
	midway late "frames are late by 2 ms and more, and overtake each other" \
		"([.boards[].repeated_or_overtaken] | add) > 0 and $most and
			(.energy_audit.residual | fabs) < 10 and .notes.extra < 200" \
		netem delay 2ms 1ms reorder 25%
}

# The default instrument at 500 Hz, and two periods from a sample to its force.
two_periods() {
	tc qdisc add dev vcan0 root netem delay 2ms
	boards two_periods $few
	play two_periods --link can:vcan0 --duration 6 --set tick_hz=500 --set render.passivity=control \
		--set keys.0.instrument=grand --set keys.1.instrument=grand \
		--set keys.2.instrument=grand --set keys.3.instrument=grand
	tc qdisc del dev vcan0 root
	if grep -q "with the delay of these links" two_periods.err; then
		[ $code = 1 ] && grep -q "at 500 Hz" two_periods.err &&
			bear two_periods ".counts.armings == 0"
	else
		[ $code = 0 ] && holds two_periods "$complete" && bear two_periods "$fresh"
	fi
	verdict two_periods "a grand at 500 Hz with two periods of delay plays as written, or is refused" \
		$? "exit $code; $(head -n 1 two_periods.err); $(notes two_periods)"
}

# Of 20 ms that forces are valid after the samples that they answer, 24 are spent on the way.
too_late() {
	midway too_late "forces that come too late are not rendered" \
		'all(.boards[]; .counted.stale + .counted.trips > 0)' netem delay 12ms
}

# What a board says of itself is taken at its word: a controller lets nothing through whose checksum
# is wrong, and set-up is not disturbed.
corrupt() {
	midway corrupt "a bit of every twentieth frame is turned" \
		"([.boards[] | .missing + .refused] | add) + .links.refused > 0" netem corrupt 5%
}

# The queue takes a part only: the tick must not wait for it.
full() {
	midway full "a queue that is full is counted, and delays no tick" \
		'([.boards[].unsent] | add) > 0 and .deadline.missed_own_work == 0 and
			.deadline.missed_preempted == 0' \
		tbf rate 3mbit burst 256 limit 2000
}

# What a controller tells of itself: passive, with 136 errors of transmission; then off the bus.
errors() {
	boards errors $few
	host errors --link can:vcan0 --duration 6
	played 3
	cansend vcan0 20000004#0010000000008800
	cansend vcan0 20000040#0000000000000000
	ended
	[ $code = 0 ] && holds errors "$complete" && holds errors "$healthy" &&
		holds errors 'all(.lines[]; .state == "off" and .transmit_errors == 136)'
	verdict errors "error frames of a controller are told and disturb nothing" $? \
		"exit $code; $(notes errors); $(of errors '.lines | tostring'); $(links errors)"
}

# outage NAME SENTENCE COMMANDS...: the bus is away for a second; the piece goes on.
outage() {
	boards "$1" $few
	host "$1" --link can:vcan0 --duration 8
	played 3
	eval "$3"
	sleep 1
	eval "$4"
	ended
	fair "$1" && holds "$1" '.notes.struck * 3 > .notes.played' && bear "$1" "$fresh" &&
		holds "$1" 'all(.boards[]; .state == "armed" and .rearmed == 1 and .counted.trips == 1)'
	verdict "$1" "$2" $? "exit $code; $(notes "$1"); $(links "$1"); $(graves "$1")"
}

down() {
	outage down "an interface that is down for a second: boards trip, are armed again, play on" \
		"ip link set vcan0 down" "ip link set vcan0 up"
}

removed() {
	outage removed "an interface that is removed and made anew: both sides come back" \
		"ip link del vcan0" "interface vcan0 72"
}

# What two boards in pieces of eight bytes have time for; the host refuses it without the controller.
slow="--set tick_hz=500 --set render.passivity=control"

# Frames in pieces of eight bytes.
# $slow is several words.
# shellcheck disable=SC2086
classic() {
	boards classic --number 3 --count 2 --keys C4..F#4 --on classic-can:vcan1
	play classic --link classic-can:vcan1 $slow --duration 6
	[ $code = 0 ] && holds classic "$complete" && holds classic "$healthy" && bear classic "$fresh"
	verdict classic "two boards of seven keys on classic CAN" $? \
		"exit $code; $(notes classic); $(links classic)"
}

# babble NAME SENTENCE CONDITION: the piece while strangers send as much as they can, by the
# processes in $strangers.
babble() {
	boards "$1" $few
	play "$1" --link can:vcan0 --duration 6
	kill $strangers
	wait $strangers 2>/dev/null
	fair "$1" && holds "$1" "$3" && bear "$1" "$fresh"
	verdict "$1" "$2" $? "exit $code; $(notes "$1"); $(links "$1"); $(graves "$1")"
}

strangers() {
	cangen vcan0 -g 1 -I 07F -L 8 -D r -i &
	strangers=$!
	cangen vcan0 -g 1 -I 690 -L 64 -D r -f -b -i &
	strangers="$strangers $!"
	babble strangers "strangers on the bus" "$complete and ($healthy)"
}

# Random bytes under identifiers of forces, samples and replies.
forged() {
	strangers=
	for id in 183 203 403 483; do
		cangen vcan0 -g 5 -I $id -L 24 -D r -f -b -i &
		strangers="$strangers $!"
	done
	babble forged "random bytes under the identifiers of a board are refused" \
		"$most and ([.boards[].refused] | add) + .links.refused > 0"
}

# busy: the last load that canbusload told, a whole number of per cent.
busy() { sed -n 's/.*vcan1@1000000.* \([0-9]*\)%.*/\1/p' load.bus | tail -n 1; }

# How busy the same boards' bus would be, as can-utils count it; they know no CAN FD here.
# shellcheck disable=SC2086
load() {
	boards load --number 3 --count 2 --keys C4..F#4 --on classic-can:vcan1
	host load --link classic-can:vcan1 $slow --performance none --duration 5
	sleep 2
	timeout 2 canbusload -e vcan1@1000000 >load.bus
	ended
	# Two boards of seven keys in pieces at 500 Hz: four fifths of a bus of 1 Mbit/s.
	[ $code = 0 ] && [ "$(busy)" -ge 60 ] && [ "$(busy)" -le 95 ]
	verdict load "how busy the bus is, by canbusload" $? \
		"$(links load); $(grep 'vcan1@1000000' load.bus | tail -n 1)"
}

# The boards crate's own tests of links.
conformance() {
	# Its name ends with a number of cargo's.
	for program in /bin/conformance*; do
		if [ ! -x "$program" ]; then
			verdict conformance "the boards crate's tests of links" 1 "they were not built"
			return
		fi
	done
	LETOFF_CAN=vcan0 "$program" >conformance.out 2>&1
	verdict conformance "the boards crate's tests of links on this interface" $? \
		"$(grep '^test result' conformance.out)"
}

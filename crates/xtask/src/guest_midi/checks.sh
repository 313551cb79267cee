# Plays to real ALSA ports, listens with aseqdump, and says what was heard.

# play NAME ARGUMENTS...: starts the host; its process is $host.
play() {
	name=$1
	shift
	letoff run /scene.toml --json "$@" >"$name.json" 2>"$name.err" &
	host=$!
}

# listen NAME ARGUMENTS...: starts aseqdump; its process is $listener.
listen() {
	name=$1
	shift
	: >"$name.heard"
	aseqdump "$@" >"$name.heard" 2>&1 &
	listener=$!
}

# hang_up SIGNAL: ends the listener.
hang_up() {
	kill "-$1" "$listener"
	wait "$listener" 2>/dev/null
}

# ended: waits for the host, at most 40 s, then stops listening; the exit code is in $code.
ended() {
	within 40 eval "! kill -0 $host" || kill -KILL "$host"
	wait "$host"
	code=$?
	sleep 0.3
	hang_up TERM
}

# tally NAME: counts in what was heard, as shell variables.
#   ons offs  messages
#   hanging   notes that are on at the end
#   unasked   note-offs of a note that is off
#   cut       messages that cut sounds off, which is for emergencies
tally() {
	eval "$(awk '
		/Note on/ { ons++; on[$6] = 1 }
		/Note off/ { offs++; if (!on[$6]) unasked++; on[$6] = 0 }
		/controller 12[03], value 0/ { cut++ }
		END {
			for (note in on) hanging += on[note]
			printf "ons=%d offs=%d hanging=%d unasked=%d cut=%d\n",
				ons, offs, hanging, unasked, cut
		}' "$1.heard")"
	heard="$ons note-ons, $offs note-offs, $hanging hanging, $cut cut off"
}

# complete NAME: whether every note that was struck was heard, and ended.
complete() {
	tally "$1"
	strikes=$(sed -n 's/^  "strikes": \([0-9]*\),*$/\1/p' "$1.json")
	heard="$heard; $strikes strikes, exit $code"
	[ "$code" = 0 ] && [ "$ons" -gt 0 ] && [ "$ons" = "$strikes" ] && [ "$ons" = "$offs" ] &&
		[ "$hanging" = 0 ] && [ "$unasked" = 0 ] && [ "$cut" = 0 ]
}

# holds NAME COUNT: whether COUNT notes or more are on.
holds() {
	tally "$1"
	[ "$hanging" -ge "$2" ]
}

# rings NAME: whether anything was struck.
rings() {
	tally "$1"
	[ "$ons" -ge 1 ]
}

is_listed() { aconnect -l | grep -q "'$1'"; }

devices() {
	letoff devices >devices.out 2>&1
	grep -q "Midi Through Port-0" devices.out && grep -q "VirMIDI 0-3" devices.out
	verdict devices "letoff devices lists the kernel's ports" $? \
		"$(grep -c -e Through -e VirMIDI devices.out) of 5"
}

virtual() {
	play virtual --midi virtual --duration 6
	within 20 is_listed letoff
	listen virtual -p letoff
	ended
	complete virtual
	verdict virtual "a virtual port: every strike is heard, and ended" $? "$heard"
}

through() {
	listen through -p "Midi Through"
	play through --midi "midi through" --duration 4
	ended
	complete through
	verdict through "a port by part of its name, Midi Through" $? "$heard"
}

# The bytes that a cable would carry; the kernel leaves out a status that repeats.
raw() {
	cat /dev/snd/midiC0D1 >raw.bytes &
	listener=$!
	play raw --midi "VirMIDI 0-1" --duration 4
	ended
	od -v -A n -t u1 -w1 raw.bytes | awk '
		$1 >= 128 { status = $1; n = 0; next }
		n == 0 { first = $1; n = 1; next }
		{ n = 0 }
		status == 144 { print "raw Note on 0, note", first ", velocity", $1; next }
		status == 128 { print "raw Note off 0, note", first ", velocity", $1; next }
		status == 176 { print "raw Control change 0, controller", first ", value", $1; next }
		{ print "raw not ours:", status, first, $1 }
	' >raw.heard
	complete raw && ! grep -q "not ours" raw.heard
	verdict raw "a port by part of its name, VirMIDI: the bytes of a cable" $? "$heard"
}

terminated() {
	listen terminated
	play terminated --midi virtual --duration 15
	within 20 is_listed letoff
	aconnect letoff aseqdump
	within 20 holds terminated 3
	before=$hanging
	kill -TERM "$host"
	ended
	complete terminated && [ "$before" -ge 3 ]
	verdict terminated "SIGTERM while a chord is held ends its notes" $? "$before held; $heard"
}

# A program change as the bytes of a cable: the first key range of the scene gets a harpsichord.
programs() {
	play programs --set "midi.input=VirMIDI 0-2" --duration 12
	within 20 grep -q "simulated keys" programs.err
	printf '\300\006' >/dev/snd/midiC0D2
	within 5 grep -q "program change 7 on channel 1: 1 keys are now harpsichord" programs.err
	heard=$?
	printf '\303\177' >/dev/snd/midiC0D2
	within 5 grep -q "program change 128 on channel 4 changes nothing: no instrument" programs.err
	[ $? = 0 ] && [ $heard = 0 ]
	heard=$?
	kill -TERM "$host"
	wait "$host"
	[ $? = 0 ] && [ $heard = 0 ]
	verdict programs "a program change switches the keys of its channel" $? \
		"$(grep "program change" programs.err | tr '\n' ' ')"
}

absent() {
	letoff run /scene.toml --midi pianoteq --duration 5 >absent.out 2>absent.err
	code=$?
	sentence='no MIDI port is called "pianoteq": choose one of "Midi Through:Midi Through Port-0'
	[ $code = 1 ] && grep -q "$sentence" absent.err && grep -q 'VirMIDI 0-3' absent.err
	verdict absent "a port that does not exist is answered with those that do" $? "exit $code"
}

# back NAME SENTENCE SECONDS: the synthesizer dies while notes sound, and is back after SECONDS.
back() {
	listen "$1.before"
	within 5 is_listed aseqdump
	play "$1" --midi aseqdump --duration 18
	within 20 holds "$1.before" 3
	hang_up KILL
	[ "$3" = 0 ] || sleep "$3"
	listen "$1.after"
	within 20 rings "$1.after"
	kill -TERM "$host"
	ended
	tally "$1.before"
	left=$hanging
	tally "$1.after"
	# Of the notes that were left on, those that were not ended before anything was struck.
	kept=$(awk '
		FILENAME ~ /before/ && /Note on/ { left[$6] = 1 }
		FILENAME ~ /before/ && /Note off/ { left[$6] = 0 }
		FILENAME ~ /after/ && /Note on/ { exit }
		FILENAME ~ /after/ && /Note off/ { left[$6] = 0 }
		END { for (note in left) kept += left[note]; print kept + 0 }
	' "$1.before.heard" "$1.after.heard")
	heard="$left left, of which $kept not ended first; then $heard, exit $code"
	[ "$left" -ge 3 ] && [ "$kept" = 0 ] && [ "$ons" -gt 0 ] && [ "$hanging" = 0 ] &&
		[ "$cut" = 0 ]
	verdict "$1" "$2" $? "$heard"
}

# port: the number under which others are connected to the virtual port.
port() { aconnect -l | sed -n "s/^client \([0-9]*\): 'letoff'.*/\1/p"; }

# process WORD: the number of the process that was started with WORD.
process() {
	for words in /proc/[0-9]*/cmdline; do
		if tr '\000' '\n' <"$words" 2>/dev/null | grep -qx -e "$1"; then
			words=${words%/cmdline}
			echo "${words#/proc/}"
		fi
	done
}

# plays NAME COUNT: whether anything was struck after COUNT strikes.
plays() {
	tally "$1"
	[ "$ons" -gt "$2" ]
}

# A device file, which takes the bytes of a cable.
device() {
	listen device -p "Virtual Raw MIDI 0-3"
	play device --midi raw:/dev/snd/midiC0D3 --duration 4
	ended
	complete device
	verdict device "a device file, raw:/dev/snd/midiC0D3" $? "$heard"
}

# holding NAME ARGUMENTS...: plays to a virtual port until a chord is held, and listens; the
# number of its notes is in $before.
holding() {
	name=$1
	play "$@" --midi virtual
	within 20 is_listed letoff
	number=$(port)
	listen "$name" -p letoff
	within 20 holds "$name" 3
	before=$hanging
}

# silent NAME: whether all is ended a second later, and nothing is struck meanwhile.
silent() {
	sleep 1
	tally "$1"
	[ "$before" -ge 3 ] && [ "$hanging" = 0 ] && [ "$unasked" = 0 ] && [ "$cut" = 0 ]
}

# The listener stays connected to the port, and so hears the next host too.
killed() {
	holding killed
	kill -KILL "$host"
	wait "$host"
	silent killed
	result=$?
	verdict killed "kill -9 of the host while a chord is held: silence within a second" $result \
		"$before held; $heard"
	before=$ons
	play again --midi virtual --duration 6
	ended
	tally killed
	[ "$ons" -gt "$before" ] && [ "$hanging" = 0 ] && [ "$cut" = 0 ] && [ "$code" = 0 ]
	verdict killed "the next host has the port, to which others stayed connected" $? "$heard"
}

stopped() {
	holding stopped --duration 15
	kill -STOP "$host"
	silent stopped
	verdict stopped "SIGSTOP of the host while a chord is held: silence within a second" $? \
		"$before held; $heard"
	before=$ons
	kill -CONT "$host"
	within 20 plays stopped "$before"
	kill -TERM "$host"
	ended
	tally stopped
	[ "$ons" -gt "$before" ] && [ "$hanging" = 0 ] && [ "$unasked" = 0 ] &&
		[ "$cut" = 0 ] && [ "$code" = 0 ]
	verdict stopped "the host that goes on after SIGSTOP leaves no note" $? "$heard, exit $code"
}

# The guardian is killed, and a synthesizer that it had connected to hears from another one.
replaced() {
	listen replaced
	within 5 is_listed aseqdump
	play replaced --midi aseqdump --duration 15
	within 20 holds replaced 3
	before=$hanging
	struck=$ons
	kill -KILL "$(process midi-guardian)"
	within 10 grep -q "another MIDI guardian has ended the notes" replaced.err
	result=$?
	within 20 plays replaced "$struck"
	kill -TERM "$host"
	ended
	tally replaced
	[ "$result" = 0 ] && [ "$before" -ge 3 ] && [ "$ons" -gt "$struck" ] &&
		[ "$hanging" = 0 ] && [ "$cut" = 0 ] && [ "$code" = 0 ]
	verdict replaced "a guardian that is killed is replaced, note-offs first" $? \
		"$before held; $heard, exit $code"
}

devices
virtual
through
raw
device
terminated
programs
absent
killed
stopped
replaced
back later "a synthesizer that is started again after 3 s is connected again" 3
back soon "a synthesizer that is started again at once is connected again" 0

# Boards and a host beside each other, and what they say of each other. Sourced by checks.sh.

# busybox prefers its own, which know neither CAN nor disturbances.
ip() { /bin/ip "$@"; }
tc() { /bin/tc "$@"; }

# The boards' processes.
boards=

# boards NAME ARGUMENTS...: starts simulated boards, which say where they are, and in the end
# what became of them, in NAME.boards; may be called several times, with several names.
boards() {
	its=$1
	shift
	letoff board --json "$@" >"$its.boards" 2>"$its.boards.err" &
	boards="$boards $!"
}

# bury: ends all boards.
bury() {
	# They are several words.
	# shellcheck disable=SC2086
	kill -TERM $boards 2>/dev/null
	# shellcheck disable=SC2086
	wait $boards
	boards=
}

# host NAME ARGUMENTS...: starts the host; its process is $host, its report NAME.json.
host() {
	name=$1
	shift
	# One emulated processor has none to spare for telemetry.
	letoff run /scene.toml --json --quiet --black-box none --listen none "$@" >"$name.json" 2>"$name.err" &
	host=$!
}

# ended: waits for the host, then ends all boards; its exit code is in $code.
ended() {
	wait "$host"
	code=$?
	bury
}

# play NAME ARGUMENTS...: runs the host from its beginning to its end.
play() {
	host "$@"
	ended
}

# played SECONDS: waits until the host has exchanged for so long with eight boards at 1 kHz.
played() {
	from=$(frames)
	within 60 eval "[ \$((\$(frames) - $from)) -gt $(($1 * 16000)) ]"
}

# frames: how many frames have gone over the first bus.
frames() { cat /sys/class/net/vcan0/statistics/tx_packets; }

# of NAME FILTER: what jq says of the host's report; no matter if there is none.
of() { jq -r "$2" "$1.json" 2>/dev/null; }

# holds NAME CONDITION: whether it holds of the host's report; of none nothing holds, where jq alone
# would find no fault with an empty file.
holds() { jq -es "last | $2" "$1.json" >/dev/null 2>&1; }

# fair NAME: whether NAME ended well, or reported that voices or boards failed.
fair() { [ $code = 0 ] || { [ $code = 1 ] && holds "$1" ".faults > 0 or any(.boards[]; .state != \"armed\")"; }; }

# bear NAME CONDITION: whether it holds of what became of every board of NAME.
bear() { jq -es "last | all(.[]; $2)" "$1.boards" >/dev/null 2>&1; }

# Boards of two keys each, of which four are played: quicker than whole ones.
few="--count 8 --keys C4..C#4 --on can:vcan0"

# Conditions of reports.
healthy='([.boards[] | .gaps + .missing + .unsent] | add) == 0 and all(.boards[]; .state == "armed")'
complete='.notes.played > 0 and .notes.missed == 0 and .notes.extra == 0 and
	(.energy_audit.residual | fabs) < 0.001'
# No force was rendered that answers samples older than they are valid [ms], and 1 ms more.
fresh='.counts.oldest_us <= 21000 and .force_while_safe_n <= 0.001'

# notes NAME: how the piece came out.
notes() {
	of "$1" '"\(.notes.struck) of \(.notes.played) notes struck, \(.notes.extra) extra, velocities off by up to \(.notes.velocity_error.max), \(.energy_audit.residual) J unexplained"'
}

# links NAME: figures of all boards together.
links() {
	of "$1" '.boards as $b | def sum(f): [$b[] | f] | add;
		"\($b | length) boards at \([$b[].samples_hz] | min | round)/s up and \([$b[].forces_hz] | min | round)/s down, "
		+ "\(sum(.gaps)) gaps, \(sum(.missing)) missing, \(sum(.unsent)) unsent, \(sum(.refused)) refused, "
		+ "stale \(sum(.counted.stale // 0)), oldest \([$b[].counted.oldest_ms // 0] | max) ms, "
		+ "trips \(sum(.counted.trips // 0)), rearmed \(sum(.rearmed)), "
		+ "round trips p50 \([$b[].round_trip_us.p50 // 0] | max) max \([$b[].round_trip_us.max // 0] | max) us, "
		+ "\(.deadline.missed) of \(.ticks) ticks late, \(.deadline.missed_own_work) by own work"'
}

# graves NAME: figures of what became of the boards.
graves() {
	jq -rs 'last as $b | def sum(f): [$b[] | f] | add;
		"boards: \(sum(.counts.forces)) forces, \(sum(.counts.stale)) stale, oldest \([$b[].counts.oldest_us] | max) us, "
		+ "\(sum(.counts.corrupt)) corrupt, \(sum(.counts.refused)) refused, \(sum(.counts.unarmed)) while unarmed, "
		+ "\(sum(.counts.trips)) trips, \(sum(.counts.armings)) armings, "
		+ "quiet after \([$b[].quiet_after_ms // 0] | max) ms, \([$b[].force_while_safe_n] | max) N while safe, "
		+ ([$b[].state] | unique | join(" and "))' "$1.boards" 2>/dev/null
}

# interface NAME MTU: a virtual bus.
interface() {
	ip link add "$1" type vcan && ip link set "$1" mtu "$2" txqueuelen 1000 && ip link set "$1" up
}

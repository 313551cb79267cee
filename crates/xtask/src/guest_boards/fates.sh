# Hosts and boards that die, fall silent, or lie about the time. Sourced by checks.sh.

# The host is killed while a chord is held.
killed() {
	boards killed $few
	host killed --link can:vcan0 --duration 18
	played 4
	kill -KILL "$host"
	wait "$host" 2>/dev/null
	sleep 1
	bury
	bear killed "$fresh"' and .state == "its forces expired" and .counts.trips == 1 and
		.force_n < 0.001 and .quiet_after_ms != null and .quiet_after_ms <= 12'
	verdict killed "the host is killed in a chord: no force is left, and boards stay safe" $? \
		"$(graves killed)"
}

# Another host finds them, arms them and plays.
another() {
	boards another $few
	host another.first --link can:vcan0 --performance none
	played 1
	kill -KILL "$host"
	wait "$host" 2>/dev/null
	sleep 0.5
	play another --link can:vcan0 --duration 6
	[ $code = 0 ] && holds another "$complete" && holds another "$healthy" &&
		bear another "$fresh and .counts.trips == 1 and .counts.armings == 2"
	verdict another "a host that comes after arms them again and plays" $? \
		"exit $code; $(notes another); $(links another); $(graves another)"
}

# fate NAME SENTENCE FATE CONDITION: something befalls board 1, where nobody plays; the others
# notice nothing.
fate() {
	boards "$1" $few --fate "1@$3"
	play "$1" --link can:vcan0 --duration 5
	others="$1.others"
	jq '.boards |= map(select(.number != 1))' "$1.json" >"$others.json" 2>/dev/null
	one='.boards[] | select(.number == 1) | '
	fair "$1" && holds "$others" "$complete" && holds "$others" "$healthy" &&
		holds "$others" '([.boards[] | .counted.trips] | add) == 0' &&
		holds "$1" "$one $4" && bear "$1" "$fresh"
	verdict "$1" "$2" $? "exit $code; $(notes "$1"); the others: $(links "$others"); the one: $(
		of "$1" "$one"'"\(.missing) missing, \(.refused) refused, rearmed \(.rearmed), jumps \(.clock_jumps), \(.counted.trips // 0) trips, \(.state)"'
	)"
}

die() {
	fate die "a board dies: it is named, and the others play on" 2:die '.state != "armed"'
}

all_fates() {
	fate restart "a board starts anew: it is armed again" 2:restart=0.5 \
		'.state == "armed" and .rearmed == 1'
	fate mute "a board is mute for a while" 2:mute=0.5 \
		'.state == "armed" and .missing + .rearmed > 0'
	fate deaf "a board is deaf for a while: it trips, and is armed again" 2:deaf=0.5 \
		'.state == "armed" and .rearmed >= 1'
	fate freeze "a board stands still for a while" 2:freeze=0.5 \
		'.state == "armed" and .rearmed >= 1'
	fate babbling "a board babbles" 2:babble=0.5 \
		'.state == "armed"'
	fate backwards "a board's clock goes back" 2:backwards=0.3 \
		'.state == "armed" and .clock_jumps >= 1'
	fate faulty "a key of a board fails: it stays without force, and is named" 2:key-fault \
		'.state == "a key, motor or sensor failed"'
}

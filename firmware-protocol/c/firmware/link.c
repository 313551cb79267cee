#include "link.h"

#include "uart.h"

static bool send(const uint8_t *frame, size_t len)
{
    uint8_t wire[LETOFF_MAX_WIRE];
    return uart_write(wire, letoff_wire(frame, len, wire));
}

static void broadcast(struct state *state, const struct letoff_broadcast *said, uint32_t now_us)
{
    switch (said->what) {
    case LETOFF_BROADCAST_STOP:
        arm_stop(&state->arm, LETOFF_SAFE_EMERGENCY_STOP, now_us);
        log_write(&state->log, now_us, "emergency stop: safe");
        break;
    case LETOFF_BROADCAST_TIME:
        state->bus.heard = true;
        state->bus.heard_us = now_us;
        state->bus.ahead_us = said->host_us - now_us;
        break;
    default:
        state->hello_due = true;
        state->hello_us = now_us + 1000u * BOARD;
    }
}

static void count_forces(struct state *state, enum forces_outcome outcome)
{
    uint32_t *const counters[] = {
        [FORCES_TAKEN] = &state->counters.forces,
        [FORCES_STALE] = &state->counters.stale,
        [FORCES_REFUSED] = &state->counters.refused,
    };
    count(counters[outcome]);
}

static bool take_broadcast(struct state *state, const uint8_t *frame, size_t len, uint32_t now_us)
{
    struct letoff_broadcast said;
    if (letoff_broadcast_take(&said, frame, len) != LETOFF_TAKEN) {
        return false;
    }
    broadcast(state, &said, now_us);
    return true;
}

static bool take_forces(struct state *state, const uint8_t *frame, size_t len, uint32_t now_us)
{
    struct letoff_forces forces;
    if (letoff_forces_take(&forces, state->arm.packing, N_KEYS, frame, len) != LETOFF_TAKEN) {
        return false;
    }
    count_forces(state, forces_take(&state->forces, &state->arm, &state->history, &forces, now_us));
    return true;
}

static bool take_multicast(struct state *state, const uint8_t *frame, size_t len, uint32_t now_us)
{
    struct letoff_multicast forces;
    if (letoff_multicast_take(&forces, frame, len) != LETOFF_TAKEN) {
        return false;
    }
    count_forces(state, forces_multicast(&state->forces, &state->arm, &state->bus, &forces,
                                         FIRST_KEY, N_KEYS, now_us));
    return true;
}

static bool take_request(struct link *link, struct state *state, const uint8_t *frame, size_t len,
                         uint32_t now_us)
{
    struct letoff_acyclic request;
    if (letoff_request_take(&request, frame, len) != LETOFF_TAKEN) {
        return false;
    }
    acyclic_answer(&link->acyclic, state, &request, now_us);
    /* If there is no room for the answer, the host asks again. */
    (void)send(link->acyclic.reply, link->acyclic.len);
    return true;
}

/* Gives a frame to whom it concerns; false if it concerns nobody here. */
static bool dispatch(struct link *link, struct state *state, const uint8_t *frame, size_t len,
                     uint32_t now_us)
{
    if (len == 0) {
        return false;
    }
    bool ours = letoff_board(frame) == BOARD;
    switch (letoff_kind(frame)) {
    case LETOFF_KIND_BROADCAST:
        return take_broadcast(state, frame, len, now_us);
    case LETOFF_KIND_KEY_FORCES:
        return ours && take_forces(state, frame, len, now_us);
    case LETOFF_KIND_MULTICAST_FORCES:
        return take_multicast(state, frame, len, now_us);
    case LETOFF_KIND_REQUEST:
        return ours && take_request(link, state, frame, len, now_us);
    default:
        return false;
    }
}

void link_byte(struct link *link, struct state *state, uint8_t byte, uint32_t now_us)
{
    enum letoff_framing found = letoff_deframe(&link->deframer, byte);
    if (found == LETOFF_NOTHING_YET) {
        return;
    }
    if (found != LETOFF_FRAME) {
        count(&state->counters.corrupt);
    } else if (!dispatch(link, state, link->deframer.buffer, link->deframer.len, now_us)) {
        count(&state->counters.refused);
    }
}

void link_hello(struct state *state, uint32_t now_us)
{
    if (!state->hello_due || !is_due(state->hello_us, now_us)) {
        return;
    }
    struct letoff_introduction who = {
        BOARD,
        arm_is_safe(&state->arm),
        state_hello(state, now_us),
    };
    uint8_t frame[LETOFF_MAX_FRAME];
    state->hello_due = !send(frame, letoff_introduction_put(&who, frame));
}

/* What forces will answer. */
static struct history_entry *remember(struct state *state)
{
    bool unanswered;
    struct history_entry *entry = history_add(&state->history, state->law_us, &unanswered);
    if (unanswered) {
        count(&state->counters.unanswered);
    }
    entry->owed = state->arm.mode == ARM_ARMED && state->arm.packing != LETOFF_FORCES_MULTICAST16;
    for (size_t slot = 0; slot < N_KEYS; slot++) {
        entry->counts[slot] = plant_counts(&state->keys[slot]);
        entry->velocities[slot] = plant_velocity(&state->keys[slot]);
    }
    return entry;
}

/* A velocity as it travels, to the nearest and at most what there is room for. */
static int16_t travelling(float velocity)
{
    float units = velocity * (1e6f / LETOFF_SPEED_UNIT_UM_S);
    float nearest = units < 0.0f ? units - 0.5f : units + 0.5f;
    if (nearest <= (float)INT16_MIN) {
        return INT16_MIN;
    }
    return (float)INT16_MAX <= nearest ? INT16_MAX : (int16_t)nearest;
}

static void send_samples(struct state *state)
{
    const struct history_entry *entry = remember(state);
    struct letoff_samples samples = {
        .header = {BOARD, entry->sequence, (uint16_t)(entry->board_us & 0xFFFFu),
                   arm_is_safe(&state->arm)},
        .packing = state->stream.agreed.packing,
        .n_keys = N_KEYS,
    };
    for (size_t slot = 0; slot < N_KEYS; slot++) {
        samples.positions[slot] = entry->counts[slot];
        samples.velocities[slot] = travelling(entry->velocities[slot]);
    }
    uint8_t frame[LETOFF_MAX_FRAME];
    /* The number is spent even if there is no room, so that the host sees that one is missing. */
    count(send(frame, letoff_samples_put(&samples, frame)) ? &state->counters.samples
                                                           : &state->counters.unsent);
}

void link_samples(struct state *state, uint32_t now_us)
{
    uint32_t period = state->stream.agreed.period_us;
    if (period == 0 || !is_due(state->stream.next_us, now_us)) {
        return;
    }
    send_samples(state);
    state->stream.next_us += period;
    /* What is late is not made up for: the newest is all that counts. */
    if (is_due(state->stream.next_us, now_us)) {
        state->stream.next_us += (now_us - state->stream.next_us) / period * period + period;
    }
}

static uint32_t sooner(uint32_t idle_us, uint32_t due_us, uint32_t now_us)
{
    uint32_t left = is_due(due_us, now_us) ? 0 : due_us - now_us;
    return left < idle_us ? left : idle_us;
}

uint32_t link_idle(const struct state *state, uint32_t now_us, uint32_t most_us)
{
    uint32_t idle_us = most_us;
    if (state->stream.agreed.period_us != 0) {
        idle_us = sooner(idle_us, state->stream.next_us, now_us);
    }
    return state->hello_due ? sooner(idle_us, state->hello_us, now_us) : idle_us;
}

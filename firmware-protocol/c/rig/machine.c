#include "machine.h"

#include "../firmware/link.h"
#include "../firmware/render.h"
#include "../firmware/unit.h"
#include "encoder.h"
#include "faults.h"
#include "finger.h"
#include "motor.h"
#include "plant.h"
#include "wire.h"

#include <math.h>

/* The protocol leaves these numbers free. */
#define RESET_BROWN_OUT 2u
#define RESET_WATCHDOG 3u
/* Time without supply after a brown-out, and time that a start takes [us]. */
#define BROWN_US 300000u
#define START_US 50000u
/* Interval from one hang to the next [us]. */
#define HANG_EVERY_US 2000000u
/* A winding that is hotter has failed [°C]. */
#define TOO_HOT 120.0
/* Temperatures that boards with the faults `hot` and `keyfault` report [°C]. */
#define VERY_HOT 325.0
#define LATCHED_AT 150.0

struct machine {
    struct state state;
    struct link link;
    /* The host's time, and that of power on and of the last start [us]. */
    uint64_t now_us;
    uint64_t origin_us;
    uint64_t start_us;
    /* The board's clock [us], and its fraction. */
    uint32_t clock_us;
    double clock_rest;
    /* Without power or without firmware until then. */
    bool dark;
    uint64_t dark_until_us;
    uint32_t boots;
    uint8_t reset_reason;
    /* When faults begin after the first Arm [us]. */
    uint64_t from_us;
    bool was_armed;
    uint64_t armed_us;
    /* Keys that the board reports as muted, slot 0 in bit 0. */
    uint16_t muted;
    /* Sums over the earlier starts. */
    struct board_account before;
};

static struct machine machine;

/* ---- Identity and condition, for the firmware. ---- */

void unit_uid(uint8_t uid[6])
{
    const uint8_t own[6] = {'R', 'I', 'G', 0, 0, BOARD};
    memcpy(uid, own, sizeof own);
}

uint32_t unit_boots(void)
{
    return machine.boots;
}

uint8_t unit_reset_reason(void)
{
    return machine.reset_reason;
}

uint16_t unit_homed(void)
{
    uint16_t all = (uint16_t)((1u << N_KEYS) - 1u);
    return fault_is_on(FAULT_NOTHOMED) ? (uint16_t)(all & ~1u) : all;
}

static double temperature(size_t slot)
{
    double measured = motor_temperature(slot);
    if (slot == 0 && fault_is_on(FAULT_HOT)) {
        return VERY_HOT;
    }
    if (slot == 0 && fault_is_on(FAULT_KEYFAULT)) {
        return LATCHED_AT;
    }
    if (slot == 0 && fault_is_on(FAULT_OVERHEAT)) {
        double rise = fault_value(FAULT_OVERHEAT) - measured;
        return measured + rise * (1.0 - exp(-faults_age(machine.now_us)));
    }
    return measured;
}

static bool is_too_hot(size_t slot)
{
    bool faulty = fault_is_on(FAULT_HOT) || fault_is_on(FAULT_OVERHEAT) ||
                  fault_is_on(FAULT_KEYFAULT);
    return (slot == 0 && faulty) || TOO_HOT < temperature(slot);
}

uint16_t unit_faults(void)
{
    unsigned faults = 0;
    for (size_t slot = 0; slot < N_KEYS; slot++) {
        faults |= is_too_hot(slot) ? 1u << slot : 0u;
    }
    return (uint16_t)faults;
}

struct letoff_key_health unit_key_health(size_t slot)
{
    struct letoff_key_health health = {
        .fault = is_too_hot(slot) ? LETOFF_KEY_FAULT_TOO_HOT : LETOFF_KEY_FAULT_NONE,
        .temperature = (int16_t)lround(10.0 * temperature(slot)),
        .current = (int16_t)lround(1e3 * motor_current(slot)),
    };
    return health;
}

/* ---- Keys. ---- */

/* Moves a key for one step of the plant. */
static void step_key(size_t slot, float command, uint32_t clock_us)
{
    struct plant_step step = {
        .slot = slot,
        .command = command,
        .clock_us = clock_us,
        .now_us = machine.now_us,
        .age_us = machine.now_us - machine.origin_us,
        .powered = !machine.dark,
    };
    plant_move(&machine.state.keys[slot], &step);
}

void plant_step(struct plant_key *key, float command, uint32_t now_us)
{
    step_key((size_t)(key - machine.state.keys), command, now_us);
}

bool plant_is_still(const struct plant_key *key, float command, uint32_t until_us)
{
    (void)key;
    (void)command;
    (void)until_us;
    return false;
}

int32_t plant_counts(const struct plant_key *key)
{
    return encoder_counts((size_t)(key - machine.state.keys));
}

float plant_velocity(const struct plant_key *key)
{
    return (float)encoder_velocity((size_t)(key - machine.state.keys));
}

/* ---- Power. ---- */

/* Starts the firmware. Keys stay where they are; settings and calibrations are kept. */
static void start(uint8_t reason)
{
    struct state kept = machine.state;
    machine.dark = false;
    machine.boots++;
    machine.reset_reason = reason;
    machine.start_us = machine.now_us;
    machine.clock_us = 0;
    machine.clock_rest = 0.0;
    machine.muted = 0;
    memset(&machine.link, 0, sizeof machine.link);
    state_begin(&machine.state, 0);
    if (1 < machine.boots) {
        memcpy(machine.state.settings, kept.settings, sizeof kept.settings);
        memcpy(machine.state.calibrations, kept.calibrations, sizeof kept.calibrations);
    }
    for (size_t slot = 0; slot < N_KEYS; slot++) {
        machine.state.keys[slot] = kept.keys[slot];
        machine.state.keys[slot].gestures.n = 0;
    }
    wire_boot();
}

static void go_dark(uint8_t reason, uint64_t us)
{
    machine.before = machine_account();
    machine.before.restarts++;
    machine.dark = true;
    machine.dark_until_us = machine.now_us + us;
    machine.reset_reason = reason;
}

static double summed_force(void)
{
    double sum = 0.0;
    for (size_t slot = 0; slot < N_KEYS; slot++) {
        sum += fabs(motor_force(slot));
    }
    return sum;
}

static void check_power(void)
{
    uint64_t up_us = machine.now_us - machine.start_us;
    if (machine.dark) {
        if (machine.dark_until_us <= machine.now_us) {
            start(machine.reset_reason);
        }
    } else if (fault_is_on(FAULT_BROWN) && fault_value(FAULT_BROWN) < summed_force()) {
        go_dark(RESET_BROWN_OUT, BROWN_US);
    } else if (fault_is_on(FAULT_RESTART) && 1e6 * fault_value(FAULT_RESTART) <= (double)up_us) {
        go_dark(RESET_WATCHDOG, START_US);
    }
}

/* ---- Faults of the whole board. ---- */

static void begin_faults(void)
{
    faults_begin(machine.now_us);
    encoder_fault_begins((double)machine.state.keys[0].position);
}

static void check_faults(void)
{
    if (!machine.was_armed && machine.state.arm.mode == ARM_ARMED) {
        machine.was_armed = true;
        machine.armed_us = machine.now_us;
    }
    bool due = machine.was_armed && machine.from_us <= machine.now_us - machine.armed_us;
    if (due && !faults_began()) {
        begin_faults();
    }
    if (fault_is_on(FAULT_KEYFAULT) && machine.state.arm.reason != LETOFF_SAFE_KEY_FAULT &&
        machine.state.arm.reason != LETOFF_SAFE_EMERGENCY_STOP) {
        arm_stop(&machine.state.arm, LETOFF_SAFE_KEY_FAULT, machine.clock_us);
        log_write(&machine.state.log, machine.clock_us, "key 0: too hot");
    }
    if (fault_is_on(FAULT_STALE)) {
        for (size_t i = 0; i < LETOFF_HISTORY; i++) {
            machine.state.history.entries[i].there = false;
        }
    }
}

/* Returns `true` while the loop of the firmware stands still. */
static bool hangs(void)
{
    if (!fault_is_on(FAULT_HANG)) {
        return false;
    }
    uint64_t into_us = (uint64_t)(1e6 * faults_age(machine.now_us)) % HANG_EVERY_US;
    return (double)(HANG_EVERY_US - into_us) <= 1e6 * fault_value(FAULT_HANG);
}

/* ---- The loop. ---- */

static void receive_packet(const struct packet *packet)
{
    struct state *state = &machine.state;
    bool lies = fault_is_on(FAULT_MUTELIES);
    if (lies) {
        state->muted = machine.muted;
    }
    for (size_t i = 0; i < packet->len; i++) {
        link_byte(&machine.link, state, packet->bytes[i], machine.clock_us);
    }
    machine.muted = state->muted;
    if (lies) {
        state->muted = 0;
    }
}

static void receive(void)
{
    if (hangs()) {
        return;
    }
    for (const struct packet *packet = wire_to_board(); packet != NULL; packet = wire_to_board()) {
        if (!machine.dark) {
            receive_packet(packet);
        }
    }
}

static void send_samples(void)
{
    struct stream *stream = &machine.state.stream;
    if (stream->agreed.period_us == 0 || !is_due(stream->next_us, machine.clock_us)) {
        return;
    }
    encoder_sample();
    link_samples(&machine.state, machine.clock_us);
    if (fault_is_on(FAULT_HALF)) {
        uint32_t left_out = (uint32_t)fault_value(FAULT_HALF) - 1u;
        stream->next_us += left_out * stream->agreed.period_us;
    }
}

/* The rest of the loop in `main.c`, after the steps. */
static void finish_loop(void)
{
    receive();
    if (machine.dark || hangs()) {
        return;
    }
    if (arm_check(&machine.state.arm, machine.clock_us)) {
        log_write(&machine.state.log, machine.clock_us, "forces expired: safe");
    }
    send_samples();
    link_hello(&machine.state, machine.clock_us);
}

static void advance(uint64_t us)
{
    double ppm = fault_is_on(FAULT_DRIFT) ? fault_value(FAULT_DRIFT) : 0.0;
    machine.now_us += us;
    machine.clock_rest += (double)us * (1.0 + 1e-6 * ppm);
    uint32_t whole_us = (uint32_t)machine.clock_rest;
    machine.clock_us += whole_us;
    machine.clock_rest -= whole_us;
    wire_at(machine.now_us);
}

/* Keys fall also if no firmware runs. */
static void step_dark_keys(void)
{
    for (size_t slot = 0; slot < N_KEYS; slot++) {
        step_key(slot, 0.0f, machine.clock_us);
    }
}

/* Runs to the next whole step of the host's time, or to `until_us` if that is sooner. */
static void step(uint64_t until_us)
{
    uint64_t left_us = STEP_US - (machine.now_us - machine.origin_us) % STEP_US;
    bool whole = left_us <= until_us - machine.now_us;
    advance(whole ? left_us : until_us - machine.now_us);
    check_power();
    if (!machine.dark) {
        render(&machine.state, machine.clock_us);
    } else if (whole) {
        step_dark_keys();
    }
}

void machine_begin(uint64_t now_us, double from_s)
{
    machine.now_us = now_us;
    machine.origin_us = now_us;
    machine.from_us = (uint64_t)(1e6 * from_s);
    wire_at(now_us);
    if (machine.from_us == 0) {
        begin_faults();
    }
    motors_begin();
    start(RESET_POWER_ON);
    check_faults();
}

void machine_receive(const uint8_t *bytes, size_t len)
{
    wire_receive(bytes, len);
    receive();
    check_faults();
}

void machine_run(uint64_t until_us, bool every_step)
{
    while (machine.now_us < until_us) {
        step(until_us);
        check_faults();
        if (every_step) {
            finish_loop();
        }
    }
    finish_loop();
    check_faults();
}

uint32_t machine_idle(uint32_t most_us)
{
    return machine.dark ? most_us : link_idle(&machine.state, machine.clock_us, most_us);
}

struct board_account machine_account(void)
{
    const struct state *state = &machine.state;
    struct board_account account = machine.before;
    account.was_armed = machine.was_armed;
    account.since_arm_s = 1e-6 * (double)(machine.now_us - machine.armed_us);
    account.muted = machine.muted;
    if (machine.dark) {
        return account;
    }
    account.armings += state->arm.armings;
    account.trips += state->arm.trips;
    account.forces += state->counters.forces;
    account.refused += state->counters.refused;
    account.stale += state->counters.stale;
    account.samples += state->counters.samples;
    account.unsent += state->counters.unsent;
    return account;
}

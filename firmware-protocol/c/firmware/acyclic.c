#include "acyclic.h"

#include "unit.h"

/* What a request leads to: a status, and the length of the record at `reply`. */
struct asked {
    struct state *state;
    const uint8_t *record;
    size_t len;
    uint32_t now_us;
    uint8_t *reply;
    size_t room;
    size_t reply_len;
};

/* The function of each operation. One that no file defines is NULL, and its operation unknown. */
#define DECLARE(NAME, function, request, answer) \
    __attribute__((weak)) uint8_t answer_##function(struct asked *asked);
LETOFF_OPERATIONS(DECLARE)

uint8_t answer_hello(struct asked *asked)
{
    struct letoff_hello hello = state_hello(asked->state, asked->now_us);
    asked->reply_len = letoff_hello_put(&hello, asked->reply, asked->room);
    return LETOFF_STATUS_DONE;
}

/* The first moment from now on that is `phase_us` into a period of the bus's clock, so that boards
 * that heard the same bus time take turns. */
static uint32_t first_due(const struct bus_clock *bus, const struct letoff_stream *stream,
                          uint32_t now_us)
{
    uint32_t into = (now_us + bus->ahead_us) % stream->period_us;
    return now_us + (stream->phase_us + stream->period_us - into) % stream->period_us;
}

uint8_t answer_stream(struct asked *asked)
{
    struct letoff_stream wanted;
    if (!letoff_stream_take(&wanted, asked->record, asked->len)) {
        return LETOFF_STATUS_BAD_VALUE;
    }
    bool starts = wanted.period_us != 0;
    bool too_fast = starts && wanted.period_us < 1000000u / MAX_SAMPLE_HZ;
    bool bad_phase = starts && wanted.period_us <= wanted.phase_us;
    if (too_fast || bad_phase || letoff_samples_key_len(wanted.packing) == 0) {
        return LETOFF_STATUS_BAD_VALUE;
    }
    asked->state->stream.agreed = wanted;
    if (starts) {
        asked->state->stream.next_us = first_due(&asked->state->bus, &wanted, asked->now_us);
    }
    return LETOFF_STATUS_DONE;
}

uint8_t answer_disarm(struct asked *asked)
{
    struct letoff_disarmed disarmed;
    uint8_t status = arm_disarm(&asked->state->arm, asked->now_us, &disarmed.nonce);
    if (status != LETOFF_STATUS_DONE) {
        return status;
    }
    log_write(&asked->state->log, asked->now_us, "disarmed");
    asked->reply_len = letoff_disarmed_put(&disarmed, asked->reply, asked->room);
    return LETOFF_STATUS_DONE;
}

uint8_t answer_arm(struct asked *asked)
{
    struct letoff_arm wanted;
    if (!letoff_arm_take(&wanted, asked->record, asked->len)) {
        return LETOFF_STATUS_BAD_VALUE;
    }
    uint8_t status = arm_arm(&asked->state->arm, &wanted);
    if (status == LETOFF_STATUS_DONE) {
        forces_begin(&asked->state->forces);
        log_write(&asked->state->log, asked->now_us, "armed");
    }
    return status;
}

uint8_t answer_ping(struct asked *asked)
{
    struct letoff_pong pong = {asked->now_us};
    asked->reply_len = letoff_pong_put(&pong, asked->reply, asked->room);
    return LETOFF_STATUS_DONE;
}

static uint8_t config(struct asked *asked, uint8_t setting)
{
    struct letoff_config config = {
        asked->state->settings[setting],
        state_config_crc(asked->state),
    };
    asked->reply_len = letoff_config_put(&config, asked->reply, asked->room);
    return LETOFF_STATUS_DONE;
}

uint8_t answer_read_config(struct asked *asked)
{
    struct letoff_read_config wanted;
    if (!letoff_read_config_take(&wanted, asked->record, asked->len) ||
        LETOFF_SETTING_COUNT <= wanted.setting) {
        return LETOFF_STATUS_BAD_VALUE;
    }
    return config(asked, wanted.setting);
}

uint8_t answer_write_config(struct asked *asked)
{
    /* The largest value of each setting. */
    static const int32_t most[LETOFF_SETTING_COUNT] = {LETOFF_MAX_BOARD, LETOFF_KEYS - 1u,
                                                       MAX_FORCE_MN};
    struct letoff_write_config wanted;
    if (!letoff_write_config_take(&wanted, asked->record, asked->len) ||
        LETOFF_SETTING_COUNT <= wanted.setting || wanted.value < 0 ||
        most[wanted.setting] < wanted.value) {
        return LETOFF_STATUS_BAD_VALUE;
    }
    if (asked->state->arm.mode == ARM_ARMED) {
        return LETOFF_STATUS_WRONG_STATE;
    }
    asked->state->settings[wanted.setting] = wanted.value;
    return config(asked, wanted.setting);
}

static uint8_t calibration(struct asked *asked, uint8_t slot)
{
    const struct letoff_key_calibration *kept = &asked->state->calibrations[slot];
    asked->reply_len = letoff_key_calibration_put(kept, asked->reply, asked->room);
    return LETOFF_STATUS_DONE;
}

uint8_t answer_read_calibration(struct asked *asked)
{
    struct letoff_read_calibration wanted;
    if (!letoff_read_calibration_take(&wanted, asked->record, asked->len) ||
        N_KEYS <= wanted.slot) {
        return LETOFF_STATUS_BAD_VALUE;
    }
    return calibration(asked, wanted.slot);
}

uint8_t answer_write_calibration(struct asked *asked)
{
    struct letoff_key_calibration wanted;
    if (!letoff_key_calibration_take(&wanted, asked->record, asked->len) ||
        N_KEYS <= wanted.slot || wanted.bottom <= wanted.rest || wanted.gain_permille == 0) {
        return LETOFF_STATUS_BAD_VALUE;
    }
    if (asked->state->arm.mode == ARM_ARMED) {
        return LETOFF_STATUS_WRONG_STATE;
    }
    asked->state->calibrations[wanted.slot] = wanted;
    return calibration(asked, wanted.slot);
}

uint8_t answer_read_log(struct asked *asked)
{
    struct letoff_read_log wanted;
    struct letoff_log_line line;
    if (!letoff_read_log_take(&wanted, asked->record, asked->len) ||
        !log_read(&asked->state->log, wanted.line, &line)) {
        return LETOFF_STATUS_BAD_VALUE;
    }
    asked->reply_len = letoff_log_line_put(&line, asked->reply, asked->room);
    return LETOFF_STATUS_DONE;
}

uint8_t answer_light(struct asked *asked)
{
    struct letoff_light wanted;
    if (!letoff_light_take(&wanted, asked->record, asked->len)) {
        return LETOFF_STATUS_BAD_VALUE;
    }
    asked->state->light = wanted.seconds != 0;
    asked->state->light_us = asked->now_us + 1000000u * wanted.seconds;
    return LETOFF_STATUS_DONE;
}

uint8_t answer_counters(struct asked *asked)
{
    struct letoff_counters counters = asked->state->counters;
    counters.trips = asked->state->arm.trips;
    counters.armings = asked->state->arm.armings;
    counters.oldest_us = asked->state->forces.oldest_us;
    asked->reply_len = letoff_counters_put(&counters, asked->reply, asked->room);
    return LETOFF_STATUS_DONE;
}

uint8_t answer_finger(struct asked *asked)
{
    struct letoff_finger wanted;
    if (!letoff_finger_take(&wanted, asked->record, asked->len) || N_KEYS <= wanted.slot) {
        return LETOFF_STATUS_BAD_VALUE;
    }
    struct gestures *gestures = &asked->state->keys[wanted.slot].gestures;
    if (wanted.touch == LETOFF_FINGER_FORGET) {
        gestures->n = 0;
        return LETOFF_STATUS_DONE;
    }
    if (wanted.touch != TOUCH_PRESSED && wanted.touch != TOUCH_STRUCK) {
        return LETOFF_STATUS_BAD_VALUE;
    }
    return gestures_add(gestures, &wanted) ? LETOFF_STATUS_DONE : LETOFF_STATUS_WRONG_STATE;
}

uint8_t answer_board_health(struct asked *asked)
{
    struct letoff_board_health health = {
        .boots = unit_boots(),
        .homed = unit_homed(),
        .faults = unit_faults(),
        .muted = asked->state->muted,
    };
    asked->reply_len = letoff_board_health_put(&health, asked->reply, asked->room);
    return LETOFF_STATUS_DONE;
}

uint8_t answer_key_health(struct asked *asked)
{
    struct letoff_read_key_health wanted;
    if (!letoff_read_key_health_take(&wanted, asked->record, asked->len) ||
        N_KEYS <= wanted.slot) {
        return LETOFF_STATUS_BAD_VALUE;
    }
    struct letoff_key_health health = unit_key_health(wanted.slot);
    asked->reply_len = letoff_key_health_put(&health, asked->reply, asked->room);
    return LETOFF_STATUS_DONE;
}

uint8_t answer_mute_key(struct asked *asked)
{
    struct letoff_mute_key wanted;
    if (!letoff_mute_key_take(&wanted, asked->record, asked->len) || N_KEYS <= wanted.slot ||
        1 < wanted.muted) {
        return LETOFF_STATUS_BAD_VALUE;
    }
    uint16_t bit = (uint16_t)(1u << wanted.slot);
    uint16_t others = (uint16_t)(asked->state->muted & ~(unsigned)bit);
    asked->state->muted = wanted.muted != 0 ? (uint16_t)(others | bit) : others;
    return LETOFF_STATUS_DONE;
}

/* QEMU has none. */
uint8_t answer_bootloader(struct asked *asked)
{
    (void)asked;
    return LETOFF_STATUS_IMPOSSIBLE;
}

static uint8_t do_it(struct asked *asked, uint8_t operation)
{
#define ENTRY(NAME, function, request, answer) [LETOFF_OPERATION_##NAME] = answer_##function,
    static uint8_t (*const operations[])(struct asked *) = {LETOFF_OPERATIONS(ENTRY)};
    if (sizeof operations / sizeof *operations <= operation || operations[operation] == NULL) {
        return LETOFF_STATUS_UNKNOWN;
    }
    return operations[operation](asked);
}

void acyclic_answer(struct acyclic *acyclic, struct state *state,
                    const struct letoff_acyclic *request, uint32_t now_us)
{
    /* The same id is the same request again. If the operation is another one, it is not, and the
     * old answer would be no answer: a host that was started anew. */
    if (acyclic->answered && acyclic->reply[1] == request->id &&
        acyclic->reply[2] == request->operation) {
        return;
    }
    struct asked asked = {
        .state = state,
        .record = request->record,
        .len = request->record_len,
        .now_us = now_us,
        .reply = acyclic->reply + LETOFF_REPLY_HEAD,
        .room = sizeof acyclic->reply - LETOFF_REPLY_HEAD,
    };
    uint8_t status = do_it(&asked, request->operation);
    size_t head = letoff_reply_head(acyclic->reply, request->board, request->id,
                                    request->operation, status);
    acyclic->len = (uint8_t)(head + asked.reply_len);
    acyclic->answered = true;
}

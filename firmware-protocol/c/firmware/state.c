#include "state.h"

#include "unit.h"

void count(uint32_t *counter)
{
    if (*counter < UINT32_MAX) {
        ++*counter;
    }
}

bool is_due(uint32_t due_us, uint32_t now_us)
{
    return 0 <= letoff_signed(now_us - due_us, 32);
}

void state_begin(struct state *state, uint32_t now_us)
{
    memset(state, 0, sizeof *state);
    arm_begin(&state->arm, 0x4C544F46u + BOARD + now_us);
    state->settings[LETOFF_SETTING_BOARD] = BOARD;
    state->settings[LETOFF_SETTING_FIRST_KEY] = FIRST_KEY;
    state->settings[LETOFF_SETTING_MAX_FORCE_MN] = MAX_FORCE_MN;
    for (uint8_t slot = 0; slot < N_KEYS; slot++) {
        struct letoff_key_calibration calibration = {slot, 0, 10160, 1000};
        state->calibrations[slot] = calibration;
    }
    state->law_us = now_us;
    state->hello_due = true;
    state->hello_us = now_us + 1000u * BOARD;
    log_write(&state->log, now_us, "started");
}

/* CRC-32 of IEEE 802.3, reflected. */
static uint32_t crc32(const uint8_t *bytes, size_t len)
{
    uint32_t crc = UINT32_MAX;
    for (size_t i = 0; i < len; i++) {
        crc ^= bytes[i];
        for (int bit = 0; bit < 8; bit++) {
            crc = (crc & 1u) != 0 ? crc >> 1 ^ 0xEDB88320u : crc >> 1;
        }
    }
    return ~crc;
}

uint32_t state_config_crc(const struct state *state)
{
    uint8_t bytes[4 * LETOFF_SETTING_COUNT];
    for (size_t i = 0; i < LETOFF_SETTING_COUNT; i++) {
        letoff_put(bytes + 4 * i, (uint64_t)state->settings[i], 4);
    }
    return crc32(bytes, sizeof bytes);
}

struct letoff_hello state_hello(const struct state *state, uint32_t now_us)
{
    struct letoff_hello hello = {
        .magic = {LETOFF_MAGIC_0, LETOFF_MAGIC_1, LETOFF_MAGIC_2, LETOFF_MAGIC_3},
        .major = LETOFF_VERSION_MAJOR,
        .minor = LETOFF_VERSION_MINOR,
        .schema = LETOFF_SCHEMA_HASH,
        .first_key = FIRST_KEY,
        .n_keys = N_KEYS,
        .features = LETOFF_FEATURE_SLOPES | LETOFF_FEATURE_MULTICAST | LETOFF_FEATURE_VELOCITY |
                    LETOFF_FEATURE_FINGERS | LETOFF_FEATURE_LOG | LETOFF_FEATURE_HEALTH,
        .max_sample_hz = MAX_SAMPLE_HZ,
        .max_force_hz = MAX_FORCE_HZ,
        .law_hz = LAW_HZ,
        .quantum_nm = QUANTUM_NM,
        .max_force_mn = (uint16_t)state->settings[LETOFF_SETTING_MAX_FORCE_MN],
        .config_crc = state_config_crc(state),
        .board_us = now_us,
        .firmware_major = FIRMWARE_MAJOR,
        .firmware_minor = FIRMWARE_MINOR,
        .reset_reason = unit_reset_reason(),
        .safe_reason = state->arm.reason,
    };
    unit_uid(hello.uid);
    return hello;
}

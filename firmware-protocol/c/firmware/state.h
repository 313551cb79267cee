/* All that a board knows; all zeros but for what state_begin() sets. */
#ifndef STATE_H
#define STATE_H

#include "arm.h"
#include "board.h"
#include "forces.h"
#include "log.h"
#include "plant.h"

struct stream {
    struct letoff_stream agreed;
    /* When the next samples are due. */
    uint32_t next_us;
};

struct state {
    struct arm arm;
    struct forces forces;
    struct history history;
    struct bus_clock bus;
    struct stream stream;
    struct letoff_counters counters;
    struct log log;
    struct plant_key keys[N_KEYS];
    struct letoff_key_calibration calibrations[N_KEYS];
    int32_t settings[LETOFF_SETTING_COUNT];
    /* Keys whose motors are off, the first in bit 0. */
    uint16_t muted;
    /* Up to when law and plant have run. */
    uint32_t law_us;
    /* When a hello is due, if one is. */
    bool hello_due;
    uint32_t hello_us;
    /* Until when the light shines, if it does. */
    bool light;
    uint32_t light_us;
};

void state_begin(struct state *state, uint32_t now_us);

/* Who this board is, now. */
struct letoff_hello state_hello(const struct state *state, uint32_t now_us);

/* CRC-32 of all settings. */
uint32_t state_config_crc(const struct state *state);

/* Counters stop at their largest value. */
void count(uint32_t *counter);

/* Whether `due_us` has come. */
bool is_due(uint32_t due_us, uint32_t now_us);

#endif

/* Which frames of forces are taken, and what they set. */
#ifndef FORCES_H
#define FORCES_H

#include "arm.h"
#include "history.h"
#include "law.h"

enum forces_outcome { FORCES_TAKEN = 0, FORCES_STALE, FORCES_REFUSED };

/* All zeros is its beginning. */
struct forces {
    struct law_key keys[LETOFF_MOST_KEYS];
    /* The samples that were answered last, since the board was armed. */
    bool answered;
    uint32_t answered_us;
    /* The oldest samples that an answer was taken for [us]. */
    uint32_t oldest_us;
    /* Of each group of multicast forces: that one came, its bus time, and when it expires. */
    bool heard[LETOFF_MULTICAST_GROUPS];
    uint16_t stamps[LETOFF_MULTICAST_GROUPS];
    uint32_t deadlines[LETOFF_MULTICAST_GROUPS];
};

/* What time it is on the bus; all zeros before anybody has said so. */
struct bus_clock {
    bool heard;
    uint32_t heard_us;
    /* Host time minus board time. */
    uint32_t ahead_us;
};

/* Forgets what was answered: a new arming. */
void forces_begin(struct forces *forces);

/* Takes an answer to one of the samples in `history`. */
enum forces_outcome forces_take(struct forces *forces, struct arm *arm, struct history *history,
                                const struct letoff_forces *frame, uint32_t now_us);

/* Takes what a multicast frame has for `n_keys` keys from `first_key` on. */
enum forces_outcome forces_multicast(struct forces *forces, struct arm *arm,
                                     const struct bus_clock *bus,
                                     const struct letoff_multicast *frame, uint8_t first_key,
                                     uint8_t n_keys, uint32_t now_us);

#endif

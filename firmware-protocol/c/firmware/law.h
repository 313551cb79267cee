/* The force of one key between two frames: F0 + K (s0 − s) + B (s0' − s'), where s0 goes on at
 * s0' for a while.
 *
 * Force up and position down are positive. Everything is zero until an answer is taken.
 */
#ifndef LAW_H
#define LAW_H

#include "../letoff_codec.h"
#include "history.h"

struct law_key {
    /* F0 [N]. */
    float force;
    /* K for one count of the encoder [N]. */
    float stiffness;
    /* B [N s/m]. */
    float damping;
    /* Where the key was in the samples that were answered. */
    int32_t counts;
    float velocity;
    /* When that was [us], and how far it goes on in a microsecond [counts]. */
    uint32_t taken_us;
    float counts_per_us;
};

/* What the frame `forces` says of the key in `slot`, in answer to `samples`. */
void law_set(struct law_key *key, const struct letoff_forces *forces,
             const struct history_entry *samples, size_t slot);

/* A force that is held [mN]. */
void law_hold(struct law_key *key, int16_t millinewtons);

/* The force at `now_us` for a key at `counts` with `velocity` [m/s]: the thousandth part `share` of it, and at
 * most `limit` [N] either way. */
float law_force(const struct law_key *key, uint32_t now_us, int32_t counts, float velocity,
                int32_t share, float limit);

#endif

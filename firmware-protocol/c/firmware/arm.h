/* Whether this board may render forces: safe, disarmed, or armed until its forces expire.
 *
 *   safe      ── disarm ──▶  disarmed, with a new nonce
 *   disarmed  ── arm(nonce) ──▶  armed
 *   armed     ── silence, stop ──▶  safe      armed ── disarm ──▶ disarmed
 *
 * Forces expire from the first on that is taken after an arming. A stop and a failed key are for
 * good: they take the place of any lesser reason, and no request undoes them. Only power does.
 *
 * Times are the board's, in microseconds, and wrap.
 */
#ifndef ARM_H
#define ARM_H

#include "../letoff_protocol.h"

enum arm_mode { ARM_SAFE = 0, ARM_DISARMED, ARM_ARMED };

/* All that forces are when they are there in full. */
#define ARM_FULL 1000

struct arm {
    enum arm_mode mode;
    /* LETOFF_SAFE_*, why no force is rendered. */
    uint8_t reason;
    /* LETOFF_FORCES_*, what was agreed. */
    uint8_t packing;
    uint32_t valid_us;
    /* While armed: whether forces have come, and when they expire. */
    bool fed;
    uint32_t deadline_us;
    /* Else: since when they fade, until they have faded. */
    uint32_t fade_us;
    bool fading;
    uint32_t nonce;
    bool nonce_fresh;
    /* What nonces come from. */
    uint32_t seed;
    uint16_t trips;
    uint16_t armings;
};

void arm_begin(struct arm *arm, uint32_t seed);

/* Takes the forces away, and gives out the nonce with which they may come back, unless they are
 * away for good; returns a status of the protocol. */
uint8_t arm_disarm(struct arm *arm, uint32_t now_us, uint32_t *nonce);

/* Arms, if the nonce is right; returns a status of the protocol. */
uint8_t arm_arm(struct arm *arm, const struct letoff_arm *asked);

/* Becomes safe for `reason`; if it is safe already, only for one that is for good instead of one
 * that is not. */
void arm_stop(struct arm *arm, uint8_t reason, uint32_t now_us);

/* The forces are valid until then. */
void arm_feed(struct arm *arm, uint32_t deadline_us);

/* Becomes safe if the forces have expired; says whether they had. */
bool arm_check(struct arm *arm, uint32_t now_us);

/* How much of the forces is rendered now, 0 to ARM_FULL. Right also if nobody has checked. */
int32_t arm_share(const struct arm *arm, uint32_t now_us);

/* It renders no forces. */
bool arm_is_safe(const struct arm *arm);

#endif

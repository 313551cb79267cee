#include "arm.h"

#define FADE_US (1000 * (int32_t)LETOFF_FADE_MS)

/* Time from one moment to another, either way around the clock. */
static int32_t from_to(uint32_t from_us, uint32_t to_us)
{
    return letoff_signed(to_us - from_us, 32);
}

/* Robert Jenkins' 32-bit mix: nonces need not be secret, only never the same by habit. */
static uint32_t mix(uint32_t a)
{
    a = a + 0x7ED55D16u + (a << 12);
    a = a ^ 0xC761C23Cu ^ a >> 19;
    a = a + 0x165667B1u + (a << 5);
    a = (a + 0xD3A2646Cu) ^ a << 9;
    a = a + 0xFD7046C5u + (a << 3);
    return a ^ 0xB55A4F09u ^ a >> 16;
}

void arm_begin(struct arm *arm, uint32_t seed)
{
    memset(arm, 0, sizeof *arm);
    arm->reason = LETOFF_SAFE_NEVER_ARMED;
    arm->seed = seed;
}

/* Counters stop at their largest value. */
static void count(uint16_t *counter)
{
    if (*counter < UINT16_MAX) {
        ++*counter;
    }
}

/* Leaves the armed state. Forces that have expired before have begun to fade then. */
static void let_go(struct arm *arm, uint32_t now_us)
{
    if (arm->mode == ARM_ARMED) {
        arm->fading = arm->fed;
        arm->fade_us = from_to(arm->deadline_us, now_us) < 0 ? now_us : arm->deadline_us;
    }
}

/* Whether a board that is safe for `reason` is so for good. */
static bool latches(uint8_t reason)
{
    return reason == LETOFF_SAFE_EMERGENCY_STOP || reason == LETOFF_SAFE_KEY_FAULT;
}

uint8_t arm_disarm(struct arm *arm, uint32_t now_us, uint32_t *nonce)
{
    if (latches(arm->reason)) {
        return LETOFF_STATUS_WRONG_STATE;
    }
    let_go(arm, now_us);
    arm->mode = ARM_DISARMED;
    arm->reason = LETOFF_SAFE_DISARMED;
    uint32_t last = arm->nonce;
    do {
        arm->seed = mix(arm->seed + now_us);
        arm->nonce = arm->seed;
    } while (arm->nonce == last);
    arm->nonce_fresh = true;
    *nonce = arm->nonce;
    return LETOFF_STATUS_DONE;
}

static bool is_agreeable(const struct letoff_arm *asked)
{
    return asked->packing <= LETOFF_FORCES_MULTICAST16 &&
           LETOFF_SHORTEST_VALID_MS <= asked->valid_ms && asked->valid_ms <= LETOFF_LONGEST_VALID_MS;
}

uint8_t arm_arm(struct arm *arm, const struct letoff_arm *asked)
{
    if (arm->mode != ARM_DISARMED) {
        return LETOFF_STATUS_WRONG_STATE;
    }
    if (!arm->nonce_fresh || asked->nonce != arm->nonce) {
        return LETOFF_STATUS_WRONG_NONCE;
    }
    if (!is_agreeable(asked)) {
        return LETOFF_STATUS_BAD_VALUE;
    }
    arm->nonce_fresh = false;
    arm->mode = ARM_ARMED;
    arm->reason = LETOFF_SAFE_NONE;
    arm->fading = false;
    arm->packing = asked->packing;
    arm->valid_us = 1000u * asked->valid_ms;
    arm->fed = false;
    count(&arm->armings);
    return LETOFF_STATUS_DONE;
}

void arm_stop(struct arm *arm, uint8_t reason, uint32_t now_us)
{
    if (arm->mode == ARM_SAFE && (latches(arm->reason) || !latches(reason))) {
        return;
    }
    let_go(arm, now_us);
    arm->mode = ARM_SAFE;
    arm->reason = reason;
    arm->nonce_fresh = false;
}

void arm_feed(struct arm *arm, uint32_t deadline_us)
{
    if (arm->mode != ARM_ARMED) {
        return;
    }
    if (!arm->fed || 0 < from_to(arm->deadline_us, deadline_us)) {
        arm->fed = true;
        arm->deadline_us = deadline_us;
    }
}

bool arm_check(struct arm *arm, uint32_t now_us)
{
    if (arm->fading && FADE_US <= from_to(arm->fade_us, now_us)) {
        arm->fading = false;
    }
    if (arm->mode != ARM_ARMED || !arm->fed || from_to(arm->deadline_us, now_us) <= 0) {
        return false;
    }
    arm_stop(arm, LETOFF_SAFE_SILENCE, arm->deadline_us);
    count(&arm->trips);
    return true;
}

/* What is left after `elapsed_us` of fading. */
static int32_t faded(int32_t elapsed_us)
{
    if (elapsed_us <= 0) {
        return ARM_FULL;
    }
    return FADE_US <= elapsed_us ? 0 : ARM_FULL - elapsed_us / (FADE_US / ARM_FULL);
}

int32_t arm_share(const struct arm *arm, uint32_t now_us)
{
    if (arm->mode == ARM_ARMED) {
        return arm->fed ? faded(from_to(arm->deadline_us, now_us)) : 0;
    }
    return arm->fading ? faded(from_to(arm->fade_us, now_us)) : 0;
}

bool arm_is_safe(const struct arm *arm)
{
    return arm->mode != ARM_ARMED;
}

#include "forces.h"

/* How far bus time may seem ahead of itself [us]: what carried it took as long. */
#define FUTURE_US 5000
/* Multicast forces of any age below this have a time of their own within 16 bits [us]. */
#define OLDEST_MULTICAST_US 32000
/* After this long without bus time nobody knows how old multicast forces are [us]. */
#define BUS_SILENCE_US 1000000

void forces_begin(struct forces *forces)
{
    uint32_t oldest_us = forces->oldest_us;
    memset(forces, 0, sizeof *forces);
    forces->oldest_us = oldest_us;
}

enum forces_outcome forces_take(struct forces *forces, struct arm *arm, struct history *history,
                                const struct letoff_forces *frame, uint32_t now_us)
{
    if (arm->mode != ARM_ARMED || arm->packing != frame->packing) {
        return FORCES_REFUSED;
    }
    struct history_entry *samples =
        history_find(history, frame->header.sequence, frame->header.stamp_us);
    if (samples == NULL || arm->valid_us < now_us - samples->board_us) {
        return FORCES_STALE;
    }
    if (forces->answered && letoff_signed(samples->board_us - forces->answered_us, 32) < 0) {
        return FORCES_STALE;
    }
    for (size_t slot = 0; slot < frame->n_keys; slot++) {
        law_set(&forces->keys[slot], frame, samples, slot);
    }
    samples->answered = true;
    forces->answered = true;
    forces->answered_us = samples->board_us;
    if (forces->oldest_us < now_us - samples->board_us) {
        forces->oldest_us = now_us - samples->board_us;
    }
    arm_feed(arm, samples->board_us + arm->valid_us);
    return FORCES_TAKEN;
}

/* The age of multicast forces [us]; -1 if they are none to take. */
static int32_t multicast_age(const struct forces *forces, const struct arm *arm,
                             const struct bus_clock *bus, const struct letoff_multicast *frame,
                             uint32_t now_us)
{
    if (!bus->heard || BUS_SILENCE_US < now_us - bus->heard_us) {
        return -1;
    }
    int32_t age = letoff_signed(now_us + bus->ahead_us - frame->stamp_us, 16);
    int32_t most = arm->valid_us < OLDEST_MULTICAST_US ? (int32_t)arm->valid_us : OLDEST_MULTICAST_US;
    if (age < -FUTURE_US || most < age) {
        return -1;
    }
    uint16_t last = forces->stamps[frame->group];
    if (forces->heard[frame->group] && letoff_signed((uint64_t)(frame->stamp_us - last), 16) < 0) {
        return -1;
    }
    return age < 0 ? 0 : age;
}

/* Sets the keys that stand in the frame; says whether there are any. */
static bool set_group(struct forces *forces, const struct letoff_multicast *frame,
                      uint8_t first_key, uint8_t n_keys)
{
    size_t from = (size_t)frame->group * LETOFF_MULTICAST_GROUP;
    bool any = false;
    for (size_t slot = 0; slot < n_keys; slot++) {
        size_t key = first_key + slot;
        if (from <= key && key < from + LETOFF_MULTICAST_GROUP) {
            law_hold(&forces->keys[slot], frame->flag ? 0 : frame->forces[key - from]);
            any = true;
        }
    }
    return any;
}

/* Feeds the watchdog by the oldest of the groups with keys of this board, once all have come. */
static void feed_by_groups(const struct forces *forces, struct arm *arm, uint8_t first_key,
                           uint8_t n_keys)
{
    size_t first = first_key / LETOFF_MULTICAST_GROUP;
    size_t last = (size_t)(first_key + n_keys - 1) / LETOFF_MULTICAST_GROUP;
    uint32_t deadline = forces->deadlines[first];
    for (size_t group = first; group <= last; group++) {
        if (!forces->heard[group]) {
            return;
        }
        if (letoff_signed(forces->deadlines[group] - deadline, 32) < 0) {
            deadline = forces->deadlines[group];
        }
    }
    arm_feed(arm, deadline);
}

enum forces_outcome forces_multicast(struct forces *forces, struct arm *arm,
                                     const struct bus_clock *bus,
                                     const struct letoff_multicast *frame, uint8_t first_key,
                                     uint8_t n_keys, uint32_t now_us)
{
    if (arm->mode != ARM_ARMED || arm->packing != LETOFF_FORCES_MULTICAST16) {
        return FORCES_REFUSED;
    }
    int32_t age = multicast_age(forces, arm, bus, frame, now_us);
    if (age < 0) {
        return FORCES_STALE;
    }
    if (!set_group(forces, frame, first_key, n_keys)) {
        return FORCES_REFUSED;
    }
    forces->heard[frame->group] = true;
    forces->stamps[frame->group] = frame->stamp_us;
    forces->deadlines[frame->group] = now_us - (uint32_t)age + arm->valid_us;
    feed_by_groups(forces, arm, first_key, n_keys);
    if (forces->oldest_us < (uint32_t)age) {
        forces->oldest_us = (uint32_t)age;
    }
    return FORCES_TAKEN;
}

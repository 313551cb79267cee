#include "encoder.h"

#include "../firmware/board.h"
#include "faults.h"
#include "random.h"

#include <math.h>

#define COUNTS_PER_METRE (1e9 / QUANTUM_NM)
#define COUNTS_PER_UM (1e3 / QUANTUM_NM)
/* Share of samples with a spike. */
#define SPIKES 0.02

struct reading {
    int32_t counts;
    double velocity;
};

static struct reading readings[N_KEYS];
static struct random noise;
static struct random spikes;
/* Place at which the fault began [counts]. */
static double place;
/* Samples alternate between two places. */
static bool other_place;

void encoders_begin(uint64_t seed)
{
    noise = random_from(seed, 2);
    spikes = random_from(seed, 3);
}

void encoder_fault_begins(double position)
{
    place = COUNTS_PER_METRE * position;
}

/* Position [counts] that a faulty encoder makes of `counts`. */
static double faulty_counts(double counts)
{
    if (fault_is_on(FAULT_SCALE)) {
        counts *= fault_value(FAULT_SCALE);
    }
    if (fault_is_on(FAULT_ENCSIGN)) {
        counts = -counts;
    }
    if (fault_is_on(FAULT_FROZEN) || fault_is_on(FAULT_JUMPY)) {
        counts = place;
    }
    if (fault_is_on(FAULT_JUMPY) && other_place) {
        counts += COUNTS_PER_UM * fault_value(FAULT_JUMPY);
    }
    if (fault_is_on(FAULT_SHIFT)) {
        counts += COUNTS_PER_UM * fault_value(FAULT_SHIFT);
    }
    if (fault_is_on(FAULT_NOISE)) {
        double most = COUNTS_PER_UM * fault_value(FAULT_NOISE);
        counts += random_between(&noise, -most, most);
    }
    return counts;
}

static double faulty_velocity(double velocity)
{
    if (fault_is_on(FAULT_VELZERO) || fault_is_on(FAULT_FROZEN) || fault_is_on(FAULT_JUMPY)) {
        return 0.0;
    }
    if (fault_is_on(FAULT_SCALE)) {
        velocity *= fault_value(FAULT_SCALE);
    }
    if (fault_is_on(FAULT_VELSCALE)) {
        velocity *= fault_value(FAULT_VELSCALE);
    }
    bool turned = fault_is_on(FAULT_ENCSIGN) != fault_is_on(FAULT_VELSIGN);
    return turned ? -velocity : velocity;
}

void encoder_read(size_t slot, double position, double velocity)
{
    double counts = COUNTS_PER_METRE * position;
    if (slot == 0) {
        counts = faulty_counts(counts);
        velocity = faulty_velocity(velocity);
    }
    readings[slot].counts = (int32_t)floor(counts + 0.5);
    readings[slot].velocity = velocity;
}

/* Spikes last until the next reading: one sample and one step of the law. */
static void spike(enum fault fault)
{
    if (fault_is_on(fault) && random_chance(&spikes, SPIKES)) {
        readings[0].counts += (int32_t)(COUNTS_PER_UM * fault_value(fault));
    }
}

void encoder_sample(void)
{
    other_place = !other_place;
    spike(FAULT_SPIKE);
    spike(FAULT_BIGSPIKE);
}

int32_t encoder_counts(size_t slot)
{
    return readings[slot].counts;
}

double encoder_velocity(size_t slot)
{
    return readings[slot].velocity;
}

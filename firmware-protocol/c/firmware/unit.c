#include "unit.h"

#include "board.h"

void unit_uid(uint8_t uid[6])
{
    const uint8_t own[6] = {'Q', 'E', 'M', 'U', 0, BOARD};
    memcpy(uid, own, sizeof own);
}

uint32_t unit_boots(void)
{
    return 1;
}

uint8_t unit_reset_reason(void)
{
    return RESET_POWER_ON;
}

uint16_t unit_homed(void)
{
    return (uint16_t)((1u << N_KEYS) - 1u);
}

uint16_t unit_faults(void)
{
    return 0;
}

struct letoff_key_health unit_key_health(size_t slot)
{
    (void)slot;
    struct letoff_key_health health = {
        .fault = LETOFF_KEY_FAULT_NONE,
        .temperature = LETOFF_NOT_MEASURED,
        .current = LETOFF_NOT_MEASURED,
    };
    return health;
}

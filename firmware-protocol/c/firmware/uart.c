/* PL011, as the LM3S6965 has it. Baud rates are the real board's affair: QEMU ignores them. */
#include "uart.h"

#ifndef CPU_HZ
#define CPU_HZ 12500000u
#endif
#ifndef BAUD
#define BAUD 460800u
#endif

#define RCGC1 (*(volatile uint32_t *)0x400FE104u)
#define RCGC2 (*(volatile uint32_t *)0x400FE108u)
#define GPIOA_AFSEL (*(volatile uint32_t *)0x40004420u)
#define GPIOA_DEN (*(volatile uint32_t *)0x4000451Cu)
#define NVIC_ENABLE (*(volatile uint32_t *)0xE000E100u)
#define UART(at) (*(volatile uint32_t *)(0x4000C000u + (at)))
#define DR UART(0x00)
#define FR UART(0x18)
#define IBRD UART(0x24)
#define FBRD UART(0x28)
#define LCRH UART(0x2C)
#define CTL UART(0x30)
#define IFLS UART(0x34)
#define IM UART(0x38)
#define ICR UART(0x44)

#define RX_EMPTY (1u << 4)
#define TX_FULL (1u << 5)
#define RX_INTERRUPT (1u << 4)
#define TX_INTERRUPT (1u << 5)
#define TIMEOUT_INTERRUPT (1u << 6)
#define UART0_IRQ 5u
/* Framing, parity, break and overrun stand above the byte. */
#define RX_ERRORS 0xF00u

#define RING 1024u

struct ring {
    uint8_t bytes[RING];
    /* Both run on and wrap; `head` is the writer's, `tail` the reader's. */
    volatile uint32_t head;
    volatile uint32_t tail;
};

static struct ring rx;
static struct ring tx;
static volatile uint32_t lost;

void uart_begin(void)
{
    RCGC1 |= 1u << 0;
    RCGC2 |= 1u << 0;
    GPIOA_AFSEL |= 3u;
    GPIOA_DEN |= 3u;
    CTL = 0;
    /* The divisor in 64ths, to the nearest. */
    const uint32_t divisor = (CPU_HZ * 8u / BAUD + 1u) / 2u;
    IBRD = divisor / 64u;
    FBRD = divisor % 64u;
    /* Eight bits, no parity, one stop bit, with FIFOs. */
    LCRH = 0x70;
    /* An interrupt for each eighth received or nearly empty. */
    IFLS = 0;
    IM = RX_INTERRUPT | TIMEOUT_INTERRUPT;
    NVIC_ENABLE = 1u << UART0_IRQ;
    /* UART, transmitter and receiver enabled. */
    CTL = 0x301;
}

static void receive(void)
{
    while ((FR & RX_EMPTY) == 0) {
        uint32_t data = DR;
        uint32_t head = rx.head;
        if (head - rx.tail < RING && (data & RX_ERRORS) == 0) {
            rx.bytes[head % RING] = (uint8_t)data;
            rx.head = head + 1u;
        } else {
            lost++;
        }
    }
}

/* Moves what waits to the FIFO as far as it has room; asks to be called again for the rest. */
static void transmit(void)
{
    uint32_t tail = tx.tail;
    while (tail != tx.head && (FR & TX_FULL) == 0) {
        DR = tx.bytes[tail % RING];
        tail++;
    }
    tx.tail = tail;
    IM = RX_INTERRUPT | TIMEOUT_INTERRUPT | (tail != tx.head ? TX_INTERRUPT : 0u);
}

void uart0_handler(void)
{
    ICR = TX_INTERRUPT | TIMEOUT_INTERRUPT;
    receive();
    transmit();
}

int uart_read(void)
{
    uint32_t tail = rx.tail;
    if (tail == rx.head) {
        return -1;
    }
    uint8_t byte = rx.bytes[tail % RING];
    rx.tail = tail + 1u;
    return byte;
}

bool uart_write(const uint8_t *bytes, size_t len)
{
    uint32_t head = tx.head;
    if (RING - (head - tx.tail) < len) {
        return false;
    }
    for (size_t i = 0; i < len; i++) {
        tx.bytes[(head + i) % RING] = bytes[i];
    }
    __asm volatile("cpsid i" ::: "memory");
    tx.head = head + (uint32_t)len;
    transmit();
    __asm volatile("cpsie i" ::: "memory");
    return true;
}

uint32_t uart_lost(void)
{
    __asm volatile("cpsid i" ::: "memory");
    uint32_t n = lost;
    lost = 0;
    __asm volatile("cpsie i" ::: "memory");
    return n;
}

bool uart_has_byte(void)
{
    return rx.tail != rx.head;
}

//! Sound of the default device.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::time::{Duration, Instant};

use crate::message::Message;
use crate::output::{MidiSendError, Output};
use cpal::traits::{DeviceTrait as _, HostTrait as _, StreamTrait as _};
use cpal::{BufferSize, FromSample, SampleFormat, SizedSample, StreamConfig, SupportedBufferSize};
use rtrb::{Consumer, Producer, RingBuffer};
use serde::Serialize;

use super::{Font, Programs, Sampler, SoundError};

/// Wanted frames of a period: 5 ms at 48 kHz.
const PERIOD: u32 = 256;

/// Messages that may wait for the callback.
const RING: usize = 4096;

/// Largest period (frames); a device with more is served in parts.
const LARGEST: usize = 4096;

/// Slip of a clock estimate towards later times (s/s): more than the difference of two crystals.
const DRIFT: f64 = 1e-3;

/// Longest time in which notes may die away at the end.
const LONGEST_TAIL: Duration = Duration::from_secs(3);

/// Amplitude that counts as silence.
const SILENCE: f32 = 1e-4;

/// Estimate of the time at which a counter was zero, from readings that are never early.
#[derive(Clone, Copy, Debug, Default)]
struct ClockOrigin {
    /// Origin (s), and the counter of the last reading (s).
    known: Option<(f64, f64)>,
}

impl ClockOrigin {
    /// Learns that the counter was at least `counter` (s) at `now` (s); returns the origin (s).
    fn learn(&mut self, counter: f64, now: f64) -> f64 {
        let seen = now - counter;
        let origin = self
            .known
            .map_or(seen, |(origin, last)| seen.min(origin + DRIFT * (counter - last).max(0.0)));
        self.known = Some((origin, counter));
        origin
    }
}

/// Counts of the callback, shared with it.
#[derive(Debug, Default)]
pub struct SoundCounters {
    callbacks: AtomicU64,
    long: AtomicU64,
    late: AtomicU64,
    is_silent: AtomicBool,
    is_lost: AtomicBool,
}

impl SoundCounters {
    pub fn report(&self) -> SoundReport {
        let [callbacks, long, late] =
            [&self.callbacks, &self.long, &self.late].map(|it| it.load(Ordering::Relaxed));
        SoundReport { callbacks, long, late }
    }
}

/// Counts of a live sound.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, Serialize)]
pub struct SoundReport {
    pub callbacks: u64,
    /// Callbacks that took more than half of a period.
    pub long: u64,
    /// Messages that were played later than placed, since they were late.
    pub late: u64,
}

/// Output to the default sound device.
///
/// A message plays a period after its time, with its frame: the thread that sends it may be a
/// little late, and no note is moved to the edge of a period.
pub struct LiveSound {
    ring: Producer<(f64, Message)>,
    counters: Arc<SoundCounters>,
    /// Origin of the messages' times in those of `began`.
    origin: ClockOrigin,
    began: Instant,
    name: String,
    stream: cpal::Stream,
}

impl std::fmt::Debug for LiveSound {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("LiveSound").field("name", &self.name).finish_non_exhaustive()
    }
}

impl LiveSound {
    /// Opens the default device and plays silence.
    pub fn open(font: &Font, programs: &Programs) -> Result<Self, SoundError> {
        let device = cpal::default_host().default_output_device().ok_or(SoundError::NoDevice)?;
        let supported = device.default_output_config();
        let supported = supported.map_err(|_no_output| SoundError::NoDevice)?;
        let buffer_size = match supported.buffer_size() {
            SupportedBufferSize::Range { min, max } => {
                BufferSize::Fixed(PERIOD.clamp(*min, (*max).max(*min)))
            }
            SupportedBufferSize::Unknown => BufferSize::Default,
        };
        let config = StreamConfig { buffer_size, ..supported.config() };
        let name = device.description().map_or_else(|_| "default".into(), |it| it.to_string());
        let (ring, messages) = RingBuffer::new(RING);
        let (counters, began) = (Arc::<SoundCounters>::default(), Instant::now());
        let callback = Callback {
            sampler: Sampler::new(font, config.sample_rate, programs)?,
            messages,
            next: None,
            counters: Arc::clone(&counters),
            origin: ClockOrigin::default(),
            began,
            rate: f64::from(config.sample_rate),
            buffers: [vec![0.0; LARGEST], vec![0.0; LARGEST]],
        };
        let format = supported.sample_format();
        #[expect(clippy::wildcard_enum_match_arm, reason = "foreign; devices take these")]
        let stream = match format {
            SampleFormat::F32 => build::<f32>(&device, config, callback),
            SampleFormat::I32 => build::<i32>(&device, config, callback),
            SampleFormat::I16 => build::<i16>(&device, config, callback),
            _ => Err(SoundError::Device(format!("it takes samples of {format} only"))),
        }?;
        stream.play().map_err(|error| SoundError::Device(error.to_string()))?;
        Ok(Self { ring, counters, origin: ClockOrigin::default(), began, name, stream })
    }

    /// Returns the name of the device.
    pub fn name(&self) -> &str {
        &self.name
    }

    pub fn counters(&self) -> Arc<SoundCounters> {
        Arc::clone(&self.counters)
    }

    fn away(&self) -> Result<(), MidiSendError> {
        if self.counters.is_lost.load(Ordering::Relaxed) {
            return Err(MidiSendError::Away { port: self.name.clone() });
        }
        Ok(())
    }
}

impl Output for LiveSound {
    fn send(&mut self, at: f64, message: Message) -> Result<(), MidiSendError> {
        if !at.is_finite() {
            return Err(MidiSendError::NoSuchTime { at });
        }
        let due = at + self.origin.learn(at, self.began.elapsed().as_secs_f64());
        let sent = self.ring.push((due, message));
        sent.map_err(|_full| MidiSendError::Away { port: self.name.clone() })?;
        self.away()
    }

    fn poll(&mut self, _now: f64) -> Result<(), MidiSendError> {
        self.away()
    }

    fn finish(&mut self) -> Result<(), MidiSendError> {
        let begin = Instant::now();
        let is_heard = || !self.counters.is_silent.load(Ordering::Relaxed) && self.away().is_ok();
        std::thread::sleep(Duration::from_millis(50));
        while is_heard() && begin.elapsed() < LONGEST_TAIL {
            std::thread::sleep(Duration::from_millis(20));
        }
        // A device that cannot pause falls silent when the stream is dropped.
        let _paused = self.stream.pause();
        Ok(())
    }
}

fn build<T: SizedSample + FromSample<f32>>(
    device: &cpal::Device,
    config: StreamConfig,
    mut callback: Callback,
) -> Result<cpal::Stream, SoundError> {
    let channels = usize::from(config.channels).max(1);
    let counters = Arc::clone(&callback.counters);
    let lost = move |error: cpal::Error| {
        if error.kind() == cpal::ErrorKind::DeviceNotAvailable {
            counters.is_lost.store(true, Ordering::Relaxed);
        }
    };
    let render = move |frames: &mut [T], _: &cpal::OutputCallbackInfo| {
        callback.fill(frames, channels);
    };
    let stream = device.build_output_stream(config, render, lost, None);
    stream.map_err(|error| SoundError::Device(error.to_string()))
}

/// The thread of the device; it takes no lock and no memory.
struct Callback {
    sampler: Sampler,
    messages: Consumer<(f64, Message)>,
    /// Next message and its frame, if it was read from the ring.
    next: Option<(u64, Message)>,
    counters: Arc<SoundCounters>,
    /// Origin of the frames in the times of `began`.
    origin: ClockOrigin,
    began: Instant,
    /// Frames per second.
    rate: f64,
    buffers: [Vec<f32>; 2],
}

impl Callback {
    fn fill<T: SizedSample + FromSample<f32>>(&mut self, frames: &mut [T], channels: usize) {
        let begin = Instant::now();
        let n = frames.len() / channels;
        let counter = self.sampler.now() as f64 / self.rate;
        let origin = self.origin.learn(counter, (begin - self.began).as_secs_f64());
        let mut loudest = 0.0_f32;
        for part in frames.chunks_mut(LARGEST * channels) {
            loudest = loudest.max(self.part(part, channels, (origin, n)));
        }
        let period = n as f64 / self.rate;
        let counters = &self.counters;
        counters.callbacks.fetch_add(1, Ordering::Relaxed);
        let is_long = 0.5 * period < begin.elapsed().as_secs_f64();
        counters.long.fetch_add(u64::from(is_long), Ordering::Relaxed);
        let is_silent = loudest < SILENCE && self.next.is_none();
        counters.is_silent.store(is_silent, Ordering::Relaxed);
    }

    /// Fills up to [`LARGEST`] frames; returns the largest amplitude.
    fn part<T: SizedSample + FromSample<f32>>(
        &mut self,
        frames: &mut [T],
        channels: usize,
        clock: (f64, usize),
    ) -> f32 {
        let n = frames.len() / channels;
        let (begin, mut done) = (self.sampler.now(), 0);
        while done < n {
            let until = match self.next_message(clock) {
                Some((frame, message)) if frame <= self.sampler.now() => {
                    self.next = None;
                    self.sampler.play(message);
                    continue;
                }
                Some((frame, _later)) => usize::try_from(frame - begin).map_or(n, |it| it.min(n)),
                None => n,
            };
            let [left, right] = self.buffers.each_mut().map(|it| &mut it[done..until]);
            self.sampler.render(left, right);
            done = until;
        }
        let [left, right] = &self.buffers;
        let mut loudest = 0.0_f32;
        for (frame, (left, right)) in frames.chunks_mut(channels).zip(left.iter().zip(right)) {
            loudest = loudest.max(left.abs()).max(right.abs());
            for (sample, amplitude) in frame.iter_mut().zip([*left, *right].into_iter().cycle()) {
                *sample = T::from_sample(amplitude.clamp(-1.0, 1.0));
            }
        }
        loudest
    }

    /// Returns the next message and its frame, a period of `n` frames after its time; `origin` is
    /// the time of frame 0 (s).
    fn next_message(&mut self, (origin, n): (f64, usize)) -> Option<(u64, Message)> {
        if self.next.is_none() {
            let (due, message) = self.messages.pop().ok()?;
            #[expect(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "saturates"
            )]
            let frame = ((due - origin) * self.rate).round() as u64 + n as u64;
            let is_late = frame < self.sampler.now();
            self.counters.late.fetch_add(u64::from(is_late), Ordering::Relaxed);
            self.next = Some((frame, message));
        }
        self.next
    }
}

//! Free flight under gravity, in closed form or in air ([`FreeFlight`]). Heights are those of the sphere's lowest point over the
//! original surface, −δ while in contact.

use super::free_flight::FreeFlight;

/// From leaving a place until touching another one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Flight {
    /// When it begins \[s\].
    pub begin: f64,
    /// How long it lasts \[s\].
    pub duration: f64,
    /// Where it begins \[m\].
    pub height: f64,
    /// Speed upwards as it begins \[m/s\].
    pub speed: f64,
    /// Speed downwards at the next touch \[m/s\].
    pub landing_speed: f64,
    /// Gravity and air.
    pub flying: FreeFlight,
    /// The place on the surface at which it begins \[m\]: along the path of the first impact, and to the left of this path.
    pub position: [f64; 2],
    /// Velocity along the surface \[m/s\], which stays.
    pub tangential_velocity: [f64; 2],
}

impl Flight {
    /// The fall from rest at `height` to the surface.
    pub fn from_drop(flying: FreeFlight, height: f64) -> Self {
        let landing_speed = flying.landing_speed(height);
        let duration = flying.fall_time(height);
        Self {
            begin: 0.0,
            duration,
            height,
            speed: 0.0,
            landing_speed,
            flying,
            position: [0.0; 2],
            tangential_velocity: [0.0; 2],
        }
    }

    /// Upwards at `speed` from the depth `from` until the next touch at the depth `to`, both below the original surface;
    /// `None` if it does not rise that far. Without air:
    ///
    /// ```text
    /// u² = v² − 2 g (from − to),   duration = (v + u)/g
    /// ```
    pub fn from_rebound(flying: FreeFlight, begin: f64, from: f64, speed: f64, to: f64) -> Option<Self> {
        let gravity = flying.gravity;
        let flight = |[duration, landing_speed]: [f64; 2]| Self {
            begin,
            duration,
            height: -from,
            speed,
            landing_speed,
            flying,
            position: [0.0; 2],
            tangential_velocity: [0.0; 2],
        };
        if flying.has_air() {
            let fall = flying.rise_height(speed) - (from - to);
            return (fall > 0.0)
                .then(|| flight([flying.rise_time(speed) + flying.fall_time(fall), flying.landing_speed(fall)]));
        }
        let square = speed * speed - 2.0 * gravity * (from - to);
        let reaches = square > 0.0 || (from == to && speed > 0.0);
        reaches.then(|| {
            // there and back to the same height: the same speed, to the last bit
            let landing_speed = if from == to { speed } else { square.sqrt() };
            flight([(speed + landing_speed) / gravity, landing_speed])
        })
    }

    /// Returns the flight with the same take-off, without air.
    pub fn without_air(&self) -> Self {
        let flying = FreeFlight::in_vacuum(self.flying.gravity);
        let begun = if self.speed > 0.0 {
            Self::from_rebound(flying, self.begin, -self.height, self.speed, -self.height)
        } else {
            Some(Self { begin: self.begin, ..Self::from_drop(flying, self.height) })
        };
        begun.unwrap_or(*self)
    }

    /// Returns the flight of a ball that starts at this place on the surface, and moves along the surface at this velocity.
    pub fn with_tangential_motion(self, position: [f64; 2], tangential_velocity: [f64; 2]) -> Self {
        Self { position, tangential_velocity, ..self }
    }

    /// The place on the surface \[m\] at a time since the beginning \[s\].
    pub fn position_at(&self, time: f64) -> [f64; 2] {
        [0, 1].map(|axis| self.position[axis] + self.tangential_velocity[axis] * time)
    }

    /// Height over the original surface \[m\] at a time since the beginning \[s\].
    pub fn height_at(&self, time: f64) -> f64 {
        if self.flying.has_air() {
            return self.height + self.flying.height_after(self.speed, time);
        }
        self.height + time * (self.speed - 0.5 * self.flying.gravity * time)
    }

    /// Speed downwards \[m/s\], as δ' is.
    pub fn speed_at(&self, time: f64) -> f64 {
        // 0 at the release, and not -0
        0.0 - self.flying.speed_after(self.speed, time)
    }

    /// The highest point \[m\].
    pub fn apex_height(&self) -> f64 {
        self.height + self.flying.rise_height(self.speed)
    }
}

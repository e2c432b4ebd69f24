// Sliders set exact decimals: their positions are turned into digits, never into doubles.

/** The decimal `mantissa · 10^-places`, without zeros at its end. */
export function decimal(mantissa, places) {
  if (places <= 0) return String(mantissa) + "0".repeat(-places);
  const digits = String(mantissa).padStart(places + 1, "0");
  const text = `${digits.slice(0, -places)}.${digits.slice(-places)}`;
  return text.replace(/0+$/, "").replace(/\.$/, "");
}

/** Masses of two digits, from 0.01 to 1000. */
export const MASS = {
  max: 450,
  text: (k) => decimal(10 + (k % 90), 3 - Math.floor(k / 90)),
  // Only where the knob stands: the nearest position to a double near the mass.
  position(x) {
    let best = 0;
    for (let k = 0; k <= 450; k++) {
      if (Math.abs(Math.log(Number(MASS.text(k)) / x)) < Math.abs(Math.log(Number(MASS.text(best)) / x))) best = k;
    }
    return best;
  },
};

/** Restitutions in thousandths. */
export const RESTITUTION = { max: 1000, text: (k) => decimal(k, 3), position: (x) => Math.round(1000 * x) };

/** Velocities in hundredths, from -2 to 2. */
export const VELOCITY = {
  max: 400,
  text: (k) => `${k < 200 ? "-" : ""}${decimal(Math.abs(k - 200), 2)}`,
  position: (x) => Math.min(400, Math.max(0, Math.round(100 * x) + 200)),
};

/** Numbers of inserted bodies. */
export const COUNT = { max: 24, text: (k) => String(k), position: (x) => Math.min(24, x) };

/** Ties a slider to a text. */
export function attach(slider, input, scale, changed) {
  slider.min = "0";
  slider.max = String(scale.max);
  slider.step = "1";
  slider.addEventListener("input", () => {
    input.value = scale.text(Number(slider.value));
    slider.setAttribute("aria-valuetext", input.value);
    changed();
  });
}

/** Moves the knob, unless somebody holds it. */
export function move(slider, scale, x) {
  if (x === null || x === undefined || slider.matches(":active")) return;
  slider.value = String(scale.position(x));
  slider.setAttribute("aria-valuetext", scale.text(Number(slider.value)));
}

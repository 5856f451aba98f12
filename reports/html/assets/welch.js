// Welch's test in the browser, for any two designs of the page; src/solver/model/mean_difference.h is the same in C++.
function logGamma(x) { // Lanczos, g = 7
  const c = [0.99999999999980993, 676.5203681218851, -1259.1392167224028, 771.32342877765313, -176.61502916214059,
    12.507343278686905, -0.13857109526572012, 9.9843695780195716e-6, 1.5056327351493116e-7];
  const y = x - 1, t = y + 7.5;
  const sum = c.reduce((s, value, k) => (k ? s + value / (y + k) : value), 0);
  return 0.5 * Math.log(2 * Math.PI) + (y + 0.5) * Math.log(t) - t + Math.log(sum);
}

// Continued fraction of the incomplete beta function (Lentz).
function fraction(a, b, x) {
  const tiny = 1e-300;
  let c = 1, d = 1 - ((a + b) * x) / (a + 1);
  d = 1 / (Math.abs(d) < tiny ? tiny : d);
  let h = d;
  for (let m = 1; m < 300; ++m) {
    for (const factor of [(m * (b - m) * x) / ((a + 2 * m - 1) * (a + 2 * m)), (-(a + m) * (a + b + m) * x) / ((a + 2 * m) * (a + 2 * m + 1))]) {
      d = 1 + factor * d; c = 1 + factor / c;
      d = 1 / (Math.abs(d) < tiny ? tiny : d);
      c = Math.abs(c) < tiny ? tiny : c;
      h *= d * c;
    }
    if (Math.abs(d * c - 1) < 1e-12) break;
  }
  return h;
}

function incompleteBeta(a, b, x) {
  if (x <= 0 || x >= 1) return x <= 0 ? 0 : 1;
  const front = Math.exp(logGamma(a + b) - logGamma(a) - logGamma(b) + a * Math.log(x) + b * Math.log(1 - x));
  return x < (a + 1) / (a + b + 2) ? (front * fraction(a, b, x)) / a : 1 - (front * fraction(b, a, 1 - x)) / b;
}

const twoSided = (t, freedom) => incompleteBeta(freedom / 2, 0.5, freedom / (freedom + t * t));

function quantile975(freedom) {
  let low = 1.9, high = 1000;
  for (let k = 0; k < 60; ++k) {
    const middle = 0.5 * (low + high);
    if (twoSided(middle, freedom) > 0.05) low = middle; else high = middle;
  }
  return high;
}

const EXACT = 1e7; // degrees of freedom that stand for a known error

// { difference, ci95, p } of b - a; ci95 is null where an error is not known.
export function welch(a, b) {
  const difference = b.value - a.value;
  if (a.value_error === null || b.value_error === null) return { difference, ci95: null, p: 1 };
  const va = a.value_error ** 2, vb = b.value_error ** 2, error = Math.sqrt(va + vb);
  if (error === 0) return { difference, ci95: 0, p: difference === 0 ? 1 : 0 };
  const parts = va ** 2 / (a.value_freedom ?? EXACT) + vb ** 2 / (b.value_freedom ?? EXACT);
  const freedom = Math.min(EXACT, (va + vb) ** 2 / parts);
  return { difference, ci95: quantile975(freedom) * error, p: twoSided(Math.abs(difference) / error, freedom) };
}

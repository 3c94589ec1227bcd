// Numbers as text exactly as std::to_chars writes them, and back as std::from_chars reads them: for the module, which so
// goes without the tables of <charconv>. See wend/base/number_text.hpp.

/** The shortest text that reads back as the same number. */
export function shortestText(value: number): string {
  if (!Number.isFinite(value)) return notFinite(value);
  const [digits, exponent] = parts(value.toExponential());
  const fixed = fixedText(digits, exponent);
  const scientific = scientificText(digits, exponent);
  const sign = value < 0 || Object.is(value, -0) ? '-' : '';
  if (fixed.length > scientific.length) return sign + scientific;
  // A whole number of more digits than a double has is written out exactly.
  return sign + (exponent >= digits.length ? BigInt(Math.abs(value)).toString() : fixed);
}

/** Writes a number with the given number of significant digits, as printf's %g does. */
export function generalText(value: number, digits: number): string {
  if (!Number.isFinite(value)) return notFinite(value);
  const sign = value < 0 || Object.is(value, -0) ? '-' : '';
  const [exact, exponent] = parts(Math.abs(value).toExponential(100));
  const [rounded, carried] = round(exact, digits);
  const place = exponent + carried;
  const kept = rounded.replace(/0+$/, '') || '0';
  return sign + (place >= digits || place < -4 ? scientificText(kept, place) : fixedText(kept, place));
}

/** The number that the whole text is: undefined if it is not one, null if a double does not hold it. */
export function numberOf(text: string): number | undefined | null {
  const infinite = /^(-?)(inf|infinity|nan)$/i.exec(text);
  if (infinite) return /nan/i.test(text) ? NaN : infinite[1] ? -Infinity : Infinity;
  if (!/^-?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i.test(text)) return undefined;
  const value = Number(text);
  const lost = value === 0 && /[1-9]/.test(text.split(/e/i)[0]!);
  return Number.isFinite(value) && !lost ? value : null;
}

function notFinite(value: number): string {
  return Number.isNaN(value) ? 'nan' : value > 0 ? 'inf' : '-inf';
}

/** Digits without a point, and the power of ten of the first. */
function parts(exponential: string): [string, number] {
  const [mantissa, exponent] = exponential.replace(/^-/, '').split('e') as [string, string];
  return [mantissa.replace('.', ''), Number(exponent)];
}

/** Rounds decimal digits to some of them, halves to even. Also: 1 if that made one digit more. */
function round(exact: string, digits: number): [string, number] {
  const kept = exact.slice(0, digits).padEnd(digits, '0');
  const rest = exact.slice(digits);
  const half = /^50*$/.test(rest);
  const up = half ? Number(kept.at(-1)) % 2 === 1 : rest !== '' && rest[0]! >= '5';
  if (!up) return [kept, 0];
  const next = (BigInt(kept) + 1n).toString().padStart(digits, '0');
  return next.length > digits ? [next.slice(0, digits), 1] : [next, 0];
}

function fixedText(digits: string, exponent: number): string {
  if (exponent < 0) return `0.${'0'.repeat(-exponent - 1)}${digits}`;
  if (exponent + 1 >= digits.length) return digits.padEnd(exponent + 1, '0');
  return `${digits.slice(0, exponent + 1)}.${digits.slice(exponent + 1)}`;
}

function scientificText(digits: string, exponent: number): string {
  const fraction = digits.length > 1 ? `.${digits.slice(1)}` : '';
  return `${digits[0]}${fraction}e${exponent < 0 ? '-' : '+'}${String(Math.abs(exponent)).padStart(2, '0')}`;
}

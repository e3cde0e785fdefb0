// Texts of the program as a person reads them.

export function capital(text: string): string {
  return text.charAt(0).toUpperCase() + text.slice(1);
}

/** A sentence as a person reads it: a capital first, one full stop last. */
export function sentence(text: string): string {
  const trimmed = text.trim();
  if (!trimmed) return "";
  // Names of keys and curves keep their small letter.
  const whole = /^(?:a|[a-z]{2,})[\s,]/.test(trimmed) ? capital(trimmed) : trimmed;
  return /[.!?]$/.test(whole) ? whole : `${whole}.`;
}

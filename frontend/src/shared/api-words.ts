// Words that every page has, those without a server too, from orishell.structure.equilibrium.
// Do not edit:
// ORISHELL_WRITE_GOLDEN=1 python -m pytest tests/studio/test_api.py writes it anew.

/** What governs. */
export const GOVERNING = {
  panels: "the stress in panels",
  membrane: "the stress in the membrane between boards",
  creases: "the moment of creases",
  lines: "the force along a crease line",
  arms: "the stress in the arms of hinges",
  ties: "the force in a tie",
  buckling: "buckling",
} as const;

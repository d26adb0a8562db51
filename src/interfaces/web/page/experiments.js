// Experiments by name, each a scenario in the folder `experiments`.

export const EXPERIMENTS = [
  { name: "steel-ball-on-aluminium", title: "Steel ball on aluminium" },
  { name: "leeb-hardness", title: "Leeb hardness test" },
  { name: "shot-peening", title: "Shot peening: ten shots on one spot" },
  { name: "table-tennis-bounce", title: "Table-tennis bounce" },
  { name: "oblique-glass-marble", title: "Oblique impact of a glass marble" },
  { name: "hopkinson-bar", title: "Hopkinson bar" },
];

/** The file of an experiment. */
export const fileOf = (name) => new URL(`experiments/${name}.toml`, import.meta.url);

/** The text of an experiment. */
export async function experiment(name) {
  const reply = await fetch(fileOf(name));
  if (!reply.ok) throw new Error(`${fileOf(name).pathname} cannot be loaded`);
  return reply.text();
}

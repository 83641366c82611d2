// Forms of the side: gains, the referee's box, what may be opened.

const CALLS = [
  [["start", "start"], ["stop", "stop"], ["dropped_ball", "dropped ball"], ["half_time", "half-time"], ["end", "end"]],
];
const SIDED = [["kick_off", "kick-off"], ["free_kick", "free kick"], ["throw_in", "throw-in"], ["goal_kick", "goal kick"], ["corner", "corner"], ["penalty", "penalty"], ["goal", "goal"], ["subgoal", "goal back"]];
const GROUPS = ["yours", "the papers' runs", "matches", "others"];
const LOOPS = [
  ["position", "x and y", [["kp", 8], ["ki", 4], ["kd", 2]]],
  ["heading", "heading", [["kp", 12], ["ki", 6], ["kd", 2]]],
  ["wheel", "wheels", [["kp", 20], ["ki", 60]]],
];

function fillReferee(app) {
  const rows = CALLS.map((calls) => {
    const row = make("div", "", { class: "calls" });
    for (const [call, name] of calls) row.append(callButton(app, call, name, {}));
    return row;
  });
  for (const side of ["home", "away"]) {
    const row = make("div", "", { class: "calls", "data-side": side, role: "group", "aria-label": `for ${side}` });
    row.append(make("b", side));
    for (const [call, name] of SIDED) row.append(callButton(app, call, name, { side }));
    rows.push(row);
  }
  const repair = make("div", "", { class: "calls" });
  const button = make("button", "repair: picked robot goes off", { type: "button", class: "act" });
  button.addEventListener("click", () => app.actions.referee("repair", { robot: app.selected }));
  repair.append(button);
  byId("calls").replaceChildren(...rows, repair);
}

function callButton(app, call, name, more) {
  const button = make("button", name, { type: "button", class: "act", "data-call": call });
  button.addEventListener("click", () => app.actions.referee(call, more));
  return button;
}

// Sliders for the gains of the picked robot.
function fillGains(app) {
  const gains = app.gains[app.selected];
  const loops = LOOPS.filter(([loop]) => gains[loop] && !(app.moments.told.match && loop !== "wheel"));
  byId("gains").replaceChildren(...loops.map(([loop, name, sliders]) => {
    const set = make("fieldset");
    set.append(make("legend", name));
    sliders.forEach(([gain, most], k) => {
      const value = gains[loop][k];
      const label = make("label");
      const slider = make("input", "", { type: "range", min: 0, max: Math.max(most, 2 * value), step: most / 200, "data-loop": loop, "data-gain": gain, "aria-label": `${name} ${gain}` });
      slider.value = value;
      const told = make("output", number(value, 2));
      slider.addEventListener("input", () => {
        setText(told, number(Number(slider.value), 2));
        const all = Object.fromEntries([...set.querySelectorAll("input")].map((each) => [each.dataset.gain, Number(each.value)]));
        app.actions.gains(app.selected, loop, all);
      });
      label.append(make("span", gain), slider, told);
      set.append(label);
    });
    return set;
  }));
  if (!loops.length) byId("gains").append(make("p", "Its wheels have no encoders, so no loop; in a match its team commands it.", { class: "faint" }));
}

// Scenarios, and teams for those that are matches.
function fillOpener(app, hello) {
  const select = byId("scenario");
  const groups = new Map();
  for (const [name, [group]] of Object.entries(hello.scenarios)) {
    if (!groups.has(group)) groups.set(group, make("optgroup", "", { label: group }));
    groups.get(group).append(make("option", name.split(/[\\/]/).pop(), { value: name }));
  }
  select.replaceChildren(...GROUPS.filter((group) => groups.has(group)).map((group) => groups.get(group)));
  select.value = hello.opened;
  const tell = () => {
    byId("tells").title = select.value === hello.opened ? hello.about : hello.scenarios[select.value][1];
    setText(byId("tells"), byId("tells").title);
  };
  select.onchange = tell;
  tell();
  byId("teams").hidden = !hello.match;
  ["home", "away"].forEach((side, slot) => {
    const names = hello.match ? [...new Set([hello.match[slot], ...hello.teams])] : hello.teams;
    byId(`team-${side}`).replaceChildren(...names.map((name) => make("option", name, { value: name })));
  });
}

function openedBy(app) {
  const { told } = app.moments;
  const scenario = byId("scenario").value;
  const teams = {};
  if (told.match && scenario === told.opened) {
    ["home", "away"].forEach((side) => {
      const name = byId(`team-${side}`).value;
      if (told.teams.includes(name)) teams[side] = name;
    });
  }
  app.actions.open(scenario, teams);
}

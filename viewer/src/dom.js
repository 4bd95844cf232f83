// SPDX-License-Identifier: Apache-2.0
// Small helpers for elements of the page.

/// Returns a new element. attributes: properties of the element, or listeners ("onclick"); dataset and
/// style are objects. children: elements and texts.
export function make(name, attributes = {}, ...children) {
  const element = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) {
    if (key === 'dataset' || key === 'style') Object.assign(element[key], value);
    else if (key in element) element[key] = value;
    else element.setAttribute(key, value);
  }
  element.append(...children.filter((child) => child !== null && child !== undefined));
  return element;
}

export const byId = (id) => document.getElementById(id);

/// Sets the options of a select, [value, text] each, and keeps its value if it is among them.
export function setOptions(select, options, value) {
  const known = [...select.options].map((o) => [o.value, o.textContent]);
  if (JSON.stringify(known) !== JSON.stringify(options))
    select.replaceChildren(...options.map(([v, text]) => make('option', { value: v, textContent: text })));
  select.value = value;
}

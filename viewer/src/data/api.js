// SPDX-License-Identifier: Apache-2.0
// Requests to the server, or to the data within the page. Addresses are relative, so they carry the token of
// the page's own address.
import { decodePacket } from './packet.js';
import { hasData, PageData } from './page_data.js';
import { Problem } from './problem.js';

/// Data within the page; null with a server.
export const pageData = hasData() ? new PageData() : null;

function addressOf(name, query) {
  const text = new URLSearchParams(Object.entries(query).filter(([, value]) => value !== undefined));
  return `api/${name}?${text}`;
}

async function reply(name, query, options) {
  const response = await fetch(addressOf(name, query), options);
  if (response.ok) return response;
  const { problem } = await response.json().catch(() => ({}));
  throw new Problem(problem ?? `${response.status} ${response.statusText}`);
}

export const getJson = async (name, query = {}) =>
  pageData ? pageData.getJson(name, query) : (await reply(name, query)).json();
export const getPacket = async (name, query = {}) =>
  pageData
    ? pageData.getPacket(name, query)
    : decodePacket(await (await reply(name, query)).arrayBuffer());
export const requestStop = async () => (await reply('stop', {}, { method: 'POST' })).json();

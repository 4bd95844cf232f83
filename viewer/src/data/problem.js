// SPDX-License-Identifier: Apache-2.0
/// A problem that the page reports, such as a frame that cannot be read.
export class Problem extends Error {}

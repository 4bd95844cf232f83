// SPDX-License-Identifier: Apache-2.0
// The page of `thaw view`.
import { App } from './app.js';
import './style.css';

const app = new App();
window.thawView = app; // for the console of the browser, and for tests
app.start();

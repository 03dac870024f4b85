% BROWSERFINDINGS  Opens a page in a headless Chromium and says what is wrong.
%
% CALL: [FOUND, LOG] = browserFindings (FILE, WIDTH, ISDARK)
%
%   FILE    path of the page (text); it is not changed
%   WIDTH   width of the window (px)
%   ISDARK  logical: the dark colours
%   FOUND   struct: findings (cell of texts, see pageProbe.js), width, dark,
%           figures, axe (cell of texts, the violations that axe-core sees;
%           {'not installed'} where tools/axe.sh could not get it)
%   LOG     lines of the console of the page (text)
%
% See also: page.tst

function [found, log] = browserFindings (file, width, isDark)
  folder = tempname ();
  mkdir (folder);
  probe = fullfile (fileparts (mfilename ('fullpath')), 'pageProbe.js');
  copy = fullfile (folder, 'page.html');
  html = strrep (fileread (file), '</body>', ...
                 ['<script>', axeScript(), '</script><script>', ...
                  fileread(probe), '</script></body>']);
  % of the page's own rules only the one that keeps scripts out is lifted
  html = strrep (html, 'default-src ''none'';', ...
                 'default-src ''none''; script-src ''unsafe-inline'';');
  writeAtomic (copy, inFrame (html, width));
  scheme = num2str (1 - isDark);
  command = sprintf (['chromium --headless --no-sandbox --disable-gpu ', ...
                      '--user-data-dir=%s/profile --enable-logging=stderr ', ...
                      '--blink-settings=preferredColorScheme=%s ', ...
                      '--window-size=%d,1000 --virtual-time-budget=60000 ', ...
                      '--dump-dom file://%s ', ...
                      '2> %s/log'], folder, scheme, width + 200, copy, folder);
  [~, dom] = system (command);
  said = regexp (dom, '<pre id="findings">(.*?)</pre>', 'tokens', 'once');
  log = fileread (fullfile (folder, 'log'));
  lines = strsplit (log, "\n");
  log = strjoin (lines(~cellfun (@isempty, strfind (lines, 'CONSOLE'))), "\n");
  confirm_recursive_rmdir (false, 'local');
  rmdir (folder, 's');
  if isempty (said)
    error ('DEcalioc:browserFindings:runFailed', ...
           'browserFindings: the probe must report, got %d bytes and: %s', ...
           numel (dom), log);
  end
  text = said{1};
  names = {'&lt;', '&gt;', '&quot;', '&amp;'};
  signs = {'<', '>', '"', '&'};
  for k = 1:numel (names)
    text = strrep (text, names{k}, signs{k});
  end
  found = jsondecode (text);
  found.axe = cellstr (found.axe);
  found.findings = cellstr (found.findings);
  found.findings = found.findings(~cellfun (@isempty, found.findings));
end

function text = axeScript ()
  root = fileparts (fileparts (mfilename ('fullpath')));
  [~, file] = system (sprintf ('"%s" 2> /dev/null', ...
                               fullfile (root, 'tools', 'axe.sh')));
  text = '';
  if exist (strtrim (file), 'file') == 2
    text = fileread (strtrim (file));
  end
end

% A window of Chromium is never narrower than 500 px, a frame may be.
function html = inFrame (html, width)
  html = strrep (strrep (html, '&', '&amp;'), '"', '&quot;');
  html = sprintf (['<!DOCTYPE html><html><head><meta charset="utf-8">', ...
                   '<meta name="color-scheme" content="light dark">', ...
                   '</head><body><iframe width="%d" height="900" ', ...
                   'frameborder="0" srcdoc="%s"></iframe></body></html>'], ...
                  width, html);
end

% SPDX-License-Identifier: GPL-3.0-only

% REPORTPICTURES  Makes the picture of the report that the README shows.
%
% CALL: octave-cli tools/pictures/reportPictures.m [FOLDER]
%
%   FOLDER  case folder whose results/report.html is there already; default:
%           tools/demo.sh makes one in a new folder (no DEM run; two minutes)
%
% Writes docs/figures/report-gap.png with Chromium.
%
% See also: writePage

1;

function shoot (html, file, high)
  page = [tempname(), '.html'];
  writeAtomic (page, html);
  status = system (sprintf (['chromium --headless --no-sandbox ', ...
                             '--disable-gpu --hide-scrollbars ', ...
                             '--blink-settings=preferredColorScheme=1 ', ...
                             '--window-size=1180,%d --screenshot=%s ', ...
                             'file://%s 2> /dev/null'], high, ...
                            shellQuote (file), page));
  unlink (page);
  if status ~= 0
    error ('DEcalioc:reportPictures:runFailed', ...
           'reportPictures: chromium must take %s. Is it installed?', file);
  end
end

% The page with these sections alone.
function html = only (html, names)
  parts = regexp (html, '<section id="(\w+)".*?</section>', 'tokens');
  for k = 1:numel (parts)
    if ~any (strcmp (parts{k}{1}, names))
      html = regexprep (html, ['<section id="', parts{k}{1}, ...
                               '".*?</section>'], '', 'once');
    end
  end
end

root = fileparts (fileparts (fileparts (mfilename ('fullpath'))));
addpath (fullfile (root, 'infrastructure'));
startToolbox (root);
if isempty (argv ())
  % its name is the heading of the page
  folder = fullfile (privateFolder (), 'hiddenEffect');
  system ([shellQuote(fullfile (root, 'tools', 'demo.sh')), ' ', folder]);
else
  folder = argv (){end};
end
html = fileread (fullfile (folder, 'results', 'report.html'));
gap = regexprep (only (html, {'sectionwhich'}), ...
                 '<(header|nav)[ >].*?</(header|nav)>', '');
shoot (gap, fullfile (root, 'docs', 'figures', 'report-gap.png'), 830);

% SPDX-License-Identifier: GPL-3.0-only

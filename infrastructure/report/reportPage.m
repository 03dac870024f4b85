% REPORTPAGE  Brings the report page up to date; breaks nothing that goes on.
%
% CALL: reportPage (CASE, SAY, STATE)   what goes wrong is said
%       FILE = reportPage (CASE)        what goes wrong is an error
%
%   CASE   see newCase
%   SAY    function handle that takes one line of text
%   STATE  see newState; given while a calibration is under way: the page is then
%          made at most once a minute
%   FILE   path of the page (text), see writePage
%
% Made of the files in the case folder alone: nothing is run or evaluated.

function file = reportPage (Case, say, state)
  if nargin < 2
    file = writePage (pageData (Case));
    return
  end
  try
    if nargin > 2 && ~writeProgress (Case, state)
      return
    end
    if exist ('writePage', 'file') == 2        % a wing, page/
      say (['Report: ', reportPage(Case)]);
    end
  catch err
    say (['  The report page could not be written: ', ...
          strtok(err.message, "\n")]);
  end
end

% How far a calibration is: results/progress.json, which writeCalibrationJson
% removes. ISDUE  the page is to follow: the last one is older than a minute, or of
% an earlier calibration.
function isDue = writeProgress (Case, state)
  out = struct ('params', cell2struct (num2cell (state.found.params(:)), ...
                                       Case.names, 1), ...
                'probability', state.found.probability, ...
                'history', {num2cell(state.history(:)')}, ...
                'date', strftime ('%Y-%m-%d %H:%M', localtime (time ())));
  folder = fullfile (Case.folder, 'results');
  [~, ~] = mkdir (folder);
  file = fullfile (folder, 'progress.json');
  page = stat (fullfile (folder, 'report.html'));
  isDue = isempty (page) || ~isfile (file) || time () - page.mtime > 60;
  writeAtomic (file, [jsonencode(out), "\n"]);
end

%!function text = saidOf (Case, varargin)
%!  text = evalc ('reportPage (Case, @(t) printf ("%s\n", t), varargin{:})');
%!endfunction
%!test
%! raw = standInCase (tempname ());
%! Case = newCase (raw);
%! text = saidOf (Case);
%! assert (text, ['Report: ', raw.folder, "/results/report.html\n"]);
%! % under way: the first time, and when a minute has gone by
%! state.found = struct ('params', [1, 2], 'probability', 0.5);
%! state.history = [];
%! assert (strncmp (saidOf (Case, state), 'Report: ', 8));
%! assert (saidOf (Case, state), '');
%! page = fullfile (raw.folder, 'results', 'report.html');
%! system (['touch -d "2 minutes ago" ', page]);
%! assert (strncmp (saidOf (Case, state), 'Report: ', 8));
%! % a folder that cannot be written to
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (fullfile (raw.folder, 'results'), 's');
%! writeAtomic (fullfile (raw.folder, 'results'), 'a file');
%! text = saidOf (Case);
%! assert (! isempty (strfind (text, 'could not be written')));

% SPDX-License-Identifier: GPL-3.0-only

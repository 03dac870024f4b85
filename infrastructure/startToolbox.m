% STARTTOOLBOX  Puts the toolbox on the path and loads its Octave packages.
%
% CALL: startToolbox (ROOT, FOLDER)
%
%   ROOT    folder of the toolbox (text)
%   FOLDER  case folder, looked in before the toolbox (text, default pwd)
%
% optim is loaded without its dependencies: the statistics package would put
% other functions in the place of mean, median, std and var.
%
% Errors: DEcalioc:startToolbox:missingPackage, DEcalioc:startToolbox:oldOctave
%
% See also: loadCase, DEcalioc

function startToolbox (root, folder)
  if nargin < 2
    folder = pwd ();
  end
  checkOctave (OCTAVE_VERSION ());
  % before the toolbox: Octave lists all folders of its path anew with each that
  % a package adds, and those of the toolbox would be half of them
  loadPackages ({'struct', 'optim', 'parallel', 'stk'});
  % a new folder of functions is found by itself
  inside = strsplit (genpath (fullfile (root, 'infrastructure')), pathsep ());
  hasCode = cellfun (@(f) isfolder (f) && ...
                     any (~cellfun ('isempty', regexp (readdir (f), ...
                                                       '\.m$'))), inside);
  addpath (root, inside{hasCode});
  if ~strcmp (folder, root) && ~any (folder == pathsep ())  % see checkStore
    addpath (folder);
  end
  % an Octave that cannot write its history says so when it ends, and so does
  % every worker
  history_save (false);
  setenv ('OCTAVE_HISTFILE', '/dev/null');
  sigterm_dumps_octave_core (false);       % a file octave-workspace, see leaveNoCore
  sighup_dumps_octave_core (false);
  warning ('off', 'Octave:future-time-stamp');   % of disks with another clock
  if isempty (getenv ('OCTAVE_SITE_INITFILE'))
    setenv ('OCTAVE_SITE_INITFILE', ...
            fullfile (root, 'infrastructure', 'kit', 'files', 'worker.octaverc'));
  end
end

% Octave 6 has no jsonencode, in which records and results are written.
function checkOctave (number)
  if compare_versions (number, '7.0', '<')
    error ('DEcalioc:startToolbox:oldOctave', ...
           ['DEcalioc needs Octave 7 or later, got %s. Name another one, ' ...
            'OCTAVE=/path/to/octave-cli; docs/install.md says where Octave ' ...
            'comes from.'], number);
  end
end

function loadPackages (names)
  for k = 1:numel (names)
    try
      pkg ('load', '-nodeps', names{k});
    catch err
      error ('DEcalioc:startToolbox:missingPackage', ...
             ['startToolbox: the Octave package %s must be installed, ' ...
              'got: %s. On Debian: apt-get install octave-%s, or make ' ...
              'setup in the toolbox folder.'], names{k}, err.message, names{k});
    end
  end
end

%!test
%! startToolbox (fileparts (fileparts (which ('startToolbox'))));
%! assert (! isempty (which ('nonlin_residmin')));
%! assert (! isempty (which ('stk_predict')));
%! assert (isempty (strfind (which ('median'), 'shadow')));
%!test
%! % on an older Octave it says so
%! folder = emptyFolder ();
%! writeAtomic (fullfile (folder, 'OCTAVE_VERSION.m'), ...
%!              "function v = OCTAVE_VERSION ()\nv = '6.4.0';\nend\n");
%! warning ('off', 'Octave:shadowed-function', 'local');
%! addpath (folder);
%! back = onCleanup (@() rmpath (folder));
%! root = fileparts (fileparts (which ('startToolbox')));
%! fail ('startToolbox (root)', 'needs Octave 7 or later, got 6.4.0');
%!test
%! % a worker has the settings before it is called, and does not hand on how
%! given = ['disp ([sigterm_dumps_octave_core(), sighup_dumps_octave_core(), ' ...
%!          'isempty(getenv (''OCTAVE_SITE_INITFILE''))])'];
%! [status, out] = system (['octave-cli --no-history --eval ', shellQuote(given)]);
%! assert (status, 0);
%! assert (sscanf (out, '%d')', [0, 0, 1]);

% SPDX-License-Identifier: GPL-3.0-only

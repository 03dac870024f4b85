% ORIGINLINES  Says which program made a table: the first lines of a CSV.
%
% CALL: LINES = originLines ()
%       LINES = originLines (CALL)
%
%   CALL   text, the command (default: the program that runs, with its arguments)
%   LINES  1 x 5 cell of remarks, as readCsvTable skips them: program, commit (with
%          a + where code differs from it), date, machine with its load, core-hours
%          of this Octave and of what it has started
%
% See also: startTable, writeTable, originOf

function lines = originLines (call)
  if nargin < 1
    call = callText ();
  end
  root = fileparts (fileparts (mfilename ('fullpath')));
  lines = {['# program: ', call], ['# commit: ', commitText(root)], ...
           ['# date: ', strftime('%Y-%m-%d', localtime (time ()))], ...
           ['# machine: ', machineText()], ...
           sprintf('# core-hours: %.3g', processorSeconds () / 3600)};
end

% Files are written without their folders, which differ from machine to machine.
function text = callText ()
  words = argv ()';
  isPlace = ~cellfun (@isempty, regexp (words, '^/|^--', 'once'));
  words(isPlace) = cellfun (@(w) regexprep (w, '^.*/', ''), words(isPlace), ...
                            'UniformOutput', false);
  quote = ~cellfun (@isempty, regexp (words, '[\s;()]', 'once'));
  words(quote) = strcat ({'"'}, words(quote), {'"'});
  name = regexprep (program_invocation_name (), '^.*benchmarks/', '');
  if regexp (name, '\.m$')
    words = [{['benchmarks/', name]}, words];
  end
  text = strjoin ([{'octave-cli'}, words], ' ');
end

function text = commitText (root)
  git = sprintf ('git -C %s ', shellQuote (root));
  [status, text] = system ([git, 'rev-parse --short=8 HEAD 2> /dev/null']);
  if status ~= 0
    text = 'not known';
    return
  end
  text = strtrim (text);
  code = shellQuote (':!benchmarks/results');
  [~, changed] = system ([git, 'status --porcelain -- infrastructure benchmarks ', ...
                          'DEMmodels examples ', code, ' 2> /dev/null']);
  if ~isempty (changed)
    text(end + 1) = '+';
  end
end

function text = machineText ()
  text = sprintf ('%d cores', nproc ());
  if isfile ('/proc/cpuinfo')
    name = regexp (fileread ('/proc/cpuinfo'), 'model name\s*: ([^\n]*)', ...
                   'tokens', 'once');
    text = strjoin ([{text}, name], ' of ');
  end
  if isfile ('/proc/loadavg')
    load_ = sscanf (fileread ('/proc/loadavg'), '%g', 1);
    text = sprintf ('%s, load %.0f', text, load_);
  end
end

%!test
%! lines = originLines ('octave-cli benchmarks/bends.m all 1:2 CSV');
%! names = {'program', 'commit', 'date', 'machine', 'core-hours'};
%! assert (regexp (lines, '^# ([\w-]+): \S', 'tokens', 'once'), ...
%!         cellfun (@(n) {n}, names, 'UniformOutput', false));
%! % a reader of tables sees none of it
%! file = tempname ();
%! writeAtomic (file, [strjoin([lines, {'a,b', '1,x'}], "\n"), "\n"]);
%! [header, cells] = readCsvTable (file);
%! assert ({header, cells}, {{'a', 'b'}, {'1', 'x'}});

% SPDX-License-Identifier: GPL-3.0-only

% No decision compares a sentence: with each sentence of words.txt replaced by
% x1, x2 ... a calibration and the verdicts of the stored situations are the same
% but for their sentences, and so is the exit status.

%!function text = spoilt (text)
%!  % the names of the values stay, so that what a sentence needs is asked for
%!  lines = strsplit (text, "\n");
%!  for k = 1:numel (lines)
%!    code = regexp (lines{k}, '^[a-z][\w.-]*(/changed)?: ', 'match', 'once');
%!    if ~isempty (code)
%!      lines{k} = sprintf ('%sx%d', code, k);
%!    end
%!  end
%!  text = strjoin (lines, "\n");
%!endfunction
%!function s = withoutTexts (s)
%!  % what a program reads: texts of words.txt are gone, codes and numbers stay
%!  texts = {'word', 'sentence', 'gap', 'usableFor', 'notFor', 'action', ...
%!           'actionParts', 'parts', 'numbers', 'where', 'closed', 'amount', 'plain', 'text', ...
%!           'reason', 'change', 'date', 'untested'};
%!  if isstruct (s)
%!    for name = fieldnames (s)'
%!      if any (strcmp (name{1}, texts)) && ~isfield (s(1).(name{1}), 'code')
%!        s = rmfield (s, name{1});
%!      else
%!        for k = 1:numel (s)
%!          s(k).(name{1}) = withoutTexts (s(k).(name{1}));
%!        end
%!      end
%!    end
%!  elseif iscell (s)
%!    s = cellfun (@withoutTexts, s, 'UniformOutput', false);
%!  end
%!endfunction
%!function folder = spoiltToolbox ()
%!  root = fileparts (which ('DEcalioc'));
%!  folder = fullfile (tempname (), 'toolbox');
%!  mkdir (fileparts (folder));
%!  mkdir (folder);
%!  parts = {'DEcalioc.m', 'costFunction.m', 'VERSION', 'bin', 'tools', ...
%!           'infrastructure', 'share', 'DEMmodels'};
%!  quoted = cellfun (@(p) shellQuote (fullfile (root, p)), parts, ...
%!                    'UniformOutput', false);
%!  system (['cp -r ', strjoin(quoted, ' '), ' ', shellQuote(folder)]);
%!  file = fullfile (folder, 'infrastructure', 'report', 'words', 'words.txt');
%!  writeAtomic (file, spoilt (fileread (file)));
%!endfunction

%!test
%! % the decisions about all stored situations
%! coded = @(x) jsondecode (jsonencode (x));
%! verdicts = @() arrayfun (@(s) withoutTexts (decideCase (coded (s.c), ...
%!                                                     coded (s.gap))), ...
%!                      verdictCase (), 'UniformOutput', false);
%! before = verdicts ();
%! said = decideCase (coded (verdictCase ()(1).c), []).word;
%! folder = spoiltToolbox ();
%! words = fullfile (folder, 'infrastructure', 'report', 'words');
%! old = addpath (words);
%! undo = onCleanup (@() path (old));
%! assert (regexp (decideCase (coded (verdictCase ()(1).c), []).word, ...
%!                 '^x\d+$'), 1);
%! assert (isempty (regexp (said, '^x\d+$')));
%! assert (isequaln (verdicts (), before));
%! % a whole calibration, its targets out of reach
%! clear undo;
%! out = cell (1, 2);
%! status = zeros (1, 2);
%! roots = {fileparts(which ('DEcalioc')), folder};
%! for k = 1:2
%!   raw = standInCase (tempname ());
%!   writeLoadInput (raw.folder, ['optim.maxFunEvals = 2; ', ...
%!                              'optim.targetVal = {[7, 60], 1};']);
%!   status(k) = startProgram (raw.folder, ...
%!                             shellQuote (fullfile (roots{k}, ...
%!                                                   'DEcalioc.m')));
%!   file = fullfile (raw.folder, 'results', 'calibration.json');
%!   c = withoutTexts (jsondecode (fileread (file)));
%!   out{k} = rmfield (c, {'version', 'input', 'coreSeconds'});
%! end
%! assert (status(1), status(2));
%! assert (isequaln (out{:}));

% SPDX-License-Identifier: GPL-3.0-only

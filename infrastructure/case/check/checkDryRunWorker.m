% CHECKDRYRUNWORKER  Calls a model's getResults on a folder without a run.
%
% CALL: checkDryRunWorker ()
%
% For the Octave that checkFindModels starts in a folder of its own. The
% environment holds, for k = 1, 2, ..., DECALIOC_DRY_MODELk (model folder) and
% DECALIOC_DRY_NAMEk (its name), and DECALIOC_DRY_FRESH (1: to look for what a
% trial by hand has left, too). What was found goes to the file answerk, a line
% each: the number of results or NaN; why getResults can never work; the names of
% its results; then index, value and file of each element of leftoverResults, and
% the word end.

function checkDryRunWorker ()
  isFresh = strcmp (getenv ('DECALIOC_DRY_FRESH'), '1');
  k = 1;
  here = pwd ();
  while ~isempty (getenv (sprintf ('DECALIOC_DRY_MODEL%d', k)))
    model = getenv (sprintf ('DECALIOC_DRY_MODEL%d', k));
    name = getenv (sprintf ('DECALIOC_DRY_NAME%d', k));
    answer = askModel (model, name);
    if isFresh
      writeAtomic (sprintf ('answer%d', k), answer);
      left = struct2cell (leftoverResults (model, name)(:));
      answer = [answer, sprintf("%d %.5g %s\n", left{:})];
    end
    backTo (here);
    writeAtomic (sprintf ('answer%d', k), [answer, "end\n"]);
    k = k + 1;
  end
end

function answer = askModel (model, name)
  %| pragma Justify (metric, "globals", "getResults of users read it");
  global path
  here = pwd ();
  path = [here, '/'];
  funs = fullfile (model, 'OctaveFuns');
  addpath (funs);
  [~, ~] = mkdir (fullfile ('optim', name, 'empty'));
  sample = fullfile (model, 'sample');
  [count, text] = deal (NaN, '');
  if isfolder (sample)
    copy = fullfile ('optim', name, 'sample');     % copyfile runs names: $(x)
    system (['cp -rL -- ', shellQuote(sample), ' ', shellQuote(copy)]);
    [count, ~, fields] = callOnce (name, 'sample');
  end
  if isnan (count)
    [count, text, fields] = callOnce (name, 'empty');
  end
  backTo (here);
  answer = sprintf ("%g\n%s\n%s\n", count, text, ...
                    strjoin ([fields, {''}], ' '));
  rmpath (funs);
end

% A user's function may leave the folder. Octave lists all folders of its path
% with each cd, so one that changes nothing is not made.
function backTo (folder)
  if ~strcmp (pwd (), folder)
    cd (folder);
  end
end

function [count, text, fields] = callOnce (name, folder)
  [text, fields] = deal ('', {});
  try
    results = getResults (name, folder);
    count = numel (results);
    if isstruct (results)
      fields = fieldnames (results)';
      count = numel (fields);
    end
  catch err
    count = NaN;
    % only a fault that does not come from the missing files is worth telling
    marks = 'parse error|called with too many|invalid use of script';
    if ~isempty (regexp (err.message, marks, 'once')) || isMisspelt (err)
      text = regexprep (err.message, ' near line \d+, column \d+', '');
      text = strrep ([text, placeOf(ownLevel (err))], "\n", ' ');
    end
  end
end

% The innermost of the model's own functions; 1 x 0 where none is among the callers.
function level = ownLevel (err)
  level = err.stack(find (~cellfun (@isempty, strfind ({err.stack.file}, ...
                                                       'OctaveFuns')), 1));
end

function text = placeOf (level)
  text = '';
  if ~isempty (level)
    [~, base, ending] = fileparts (level.file);
    text = sprintf (' (%s%s, line %d)', base, ending, level.line);
  end
end

% A name that no line of the file gives a value: a function that is not there.
% A variable may be without one only because a file of the run is missing.
function yes = isMisspelt (err)
  name = regexp (err.message, '^''(\w+)'' undefined', 'tokens', 'once');
  level = ownLevel (err);
  yes = ~isempty (name) && ~isempty (level);
  if yes
    code = checkReadText (level.file);
    sets = ['\<', name{1}, '\>[^=\n]*=[^=]|for\s*\(?\s*', name{1}, '\>|', ...
            'function[^\n]*\<', name{1}, '\>|', ...
            '(load|eval|evalin|assignin|source|run)\>'];
    yes = isempty (regexp (code, sets, 'once'));
  end
end

%!function answer = askFor (code)
%!  here = pwd ();
%!  tidy = onCleanup (@() cd (here));
%!  work = tempname ();
%!  mkdir (fullfile (work, 'OctaveFuns'));
%!  mkdir (fullfile (work, 'sample'));
%!  writeAtomic (fullfile (work, 'sample', 'out'), '7');
%!  writeAtomic (fullfile (work, 'OctaveFuns', 'getResults.m'), code);
%!  cd (work);
%!  setenv ('DECALIOC_DRY_MODEL1', work);
%!  setenv ('DECALIOC_DRY_NAME1', 'Toy');
%!  setenv ('DECALIOC_DRY_MODEL2', '');
%!  checkDryRunWorker ();
%!  clear -global path
%!  answer = fileread ('answer1');
%!endfunction
%!test
%! % from the sample; where that throws, from a folder without files
%! head = "function res = getResults (model, name)\nglobal path\n";
%! file = 'fileread ([path, ''optim/'', model, ''/'', name, ''/out''])';
%! code = [head, 'res = struct (''a'', ', file, ', ''b'', 2); end'];
%! assert (askFor (code), "2\n\na b \nend\n");
%! assert (askFor ([head, 'if ! strcmp (name, ''empty''), x (1)(2); end, ', ...
%!                  "\nres = {1}; end"]), "1\n\n\nend\n");
%! answer = askFor ("function res = getResults ()\nres = {1};\nend\n");
%! assert (~isempty (regexp (answer, '^NaN\n.*called with too many')), answer);
%!test
%! % a function that is not there is told of, with its line; a variable that is
%! % not there as a file is missing is not
%! head = "function res = getResults (model, name)\n";
%! answer = askFor ([head, "res = num2cell (readResutls ('x'));\nend"]);
%! assert (answer, ["NaN\n'readResutls' undefined (getResults.m, line 2)\n", ...
%!                  "\nend\n"]);
%! code = [head, "if isfile ('none'), x = 1; end\nres = {x};\nend"];
%! assert (askFor (code), "NaN\n\n\nend\n");

% SPDX-License-Identifier: GPL-3.0-only

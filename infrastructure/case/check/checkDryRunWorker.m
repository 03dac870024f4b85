% CHECKDRYRUNWORKER  Calls a model's getResults on a folder without a run.
%
% CALL: checkDryRunWorker ()
%
% For the Octave that checkFindModels starts in a folder of its own. The
% environment holds DECALIOC_DRY_MODEL (model folder) and DECALIOC_DRY_NAME
% (its name). What was found goes to the file answer: the number of results
% or NaN, and below it why getResults can never work.

function checkDryRunWorker ()
  %| pragma Justify (metric, "globals", "getResults of users read it");
  global path
  path = [pwd(), '/'];
  model = getenv ('DECALIOC_DRY_MODEL');
  name = getenv ('DECALIOC_DRY_NAME');
  addpath (fullfile (model, 'OctaveFuns'));
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
  writeAtomic ([path, 'answer'], ...
               sprintf ("%g\n%s\n%s\n", count, text, ...
                        strjoin ([fields, {''}], ' ')));
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
    if ~isempty (regexp (err.message, marks, 'once'))
      text = strrep (err.message, "\n", ' ');
    end
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
%!  setenv ('DECALIOC_DRY_MODEL', work);
%!  setenv ('DECALIOC_DRY_NAME', 'Toy');
%!  checkDryRunWorker ();
%!  rmpath (fullfile (work, 'OctaveFuns'));
%!  clear -global path
%!  answer = fileread ('answer');
%!endfunction
%!test
%! % from the sample; where that throws, from a folder without files
%! head = "function res = getResults (model, name)\nglobal path\n";
%! file = 'fileread ([path, ''optim/'', model, ''/'', name, ''/out''])';
%! code = [head, 'res = struct (''a'', ', file, ', ''b'', 2); end'];
%! assert (askFor (code), "2\n\na b \n");
%! assert (askFor ([head, 'if ! strcmp (name, ''empty''), x (1)(2); end, ', ...
%!                  "\nres = {1}; end"]), "1\n\n\n");
%! answer = askFor ("function res = getResults ()\nres = {1};\nend\n");
%! assert (~isempty (regexp (answer, '^NaN\n.*called with too many')), answer);

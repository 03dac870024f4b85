% CHECKDRYRUN  Counts the results of a model without running it.
%
% CALL: [COUNT, MESSAGE, FIELDS] = checkDryRun (FOLDER, NAME)
%
%   FOLDER   model folder (text)
%   NAME     name of the model (text)
%   COUNT    number of results that its getResults returns, NaN where that
%            cannot be told
%   MESSAGE  '' or why getResults can never work (a syntax error)
%   FIELDS   1 x n cell, names of the results where getResults returns a struct
%
% getResults is called by another Octave, which a crash or a loop in it does
% not carry away (limit 20 s), on a run folder that holds only the files of
% the model's sample/, if it has one. Where that throws, an empty run folder
% is tried: published files then return NaN for each result.
%
% See also: checkCase, checkDryRunWorker

function [count, message, fields] = checkDryRun (folder, name)
  count = NaN;
  message = '';
  fields = {};
  if ~isfile (fullfile (folder, 'OctaveFuns', 'getResults.m'))
    return
  end
  work = tempname ();
  [made, ~] = mkdir (work);
  if ~made
    return
  end
  cleaner = onCleanup (@() removeFolder (work));
  here = fileparts (mfilename ('fullpath'));
  octave = fullfile (OCTAVE_EXEC_HOME (), 'bin', 'octave-cli');
  if ~isfile (octave)
    octave = 'octave-cli';
  end
  command = sprintf (['cd %s && OCTAVE_HISTFILE=/dev/null ' ...
                      'DECALIOC_DRY_MODEL=%s DECALIOC_DRY_NAME=%s ' ...
                      'timeout -k 2 20 %s --norc --quiet --no-gui ' ...
                      '--path %s --path %s --eval checkDryRunWorker ' ...
                      '> /dev/null 2>&1 < /dev/null'], shellQuote (work), ...
                     shellQuote (absolute (folder)), shellQuote (name), ...
                     shellQuote (octave), shellQuote (here), ...
                     shellQuote (fullfile (fileparts (here), 'files')));
  [~, ~] = system (command);
  [count, message, fields] = readAnswer (fullfile (work, 'answer'));
end

function removeFolder (folder)
  confirm_recursive_rmdir (false, 'local');
  [~, ~] = rmdir (folder, 's');
end

function folder = absolute (folder)
  folder = make_absolute_filename (folder);
end

function [count, message, fields] = readAnswer (file)
  count = NaN;
  lines = strsplit (checkReadText (file), "\n", 'CollapseDelimiters', false);
  lines(end + 1:3) = {''};
  number = str2double (lines{1});
  if number >= 1
    count = number;
  end
  message = strtrim (lines{2});
  fields = strsplit (strtrim (lines{3}), ' ');
  fields = fields(~cellfun (@isempty, fields));
end

%!function folder = makeModel (code)
%!  folder = tempname ();
%!  mkdir (folder);
%!  mkdir (fullfile (folder, 'OctaveFuns'));
%!  fid = fopen (fullfile (folder, 'OctaveFuns', 'getResults.m'), 'w');
%!  fputs (fid, code);
%!  fclose (fid);
%!endfunction
%!test
%! folder = makeModel (["function res = getResults (model, folderName)\n", ...
%!   "global path\ntry\n  res{1} = csvread ([path, 'optim/', model, '/',", ...
%!   " folderName, '/out']);\ncatch\n  res{1} = NaN;\nend\n", ...
%!   "res{2} = NaN;\nend\n"]);
%! [count, message] = checkDryRun (folder, 'Toy');
%! assert (count, 2);
%! assert (message, '');
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (folder, 's');
%!test
%! folder = makeModel ('function res = getResults (a, b), res = {1, ; end');
%! [count, message] = checkDryRun (folder, 'Toy');
%! assert (isnan (count) && ! isempty (strfind (message, 'parse error')));
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (folder, 's');
%!test
%! folder = makeModel (["function res = getResults (model, folderName)\n", ...
%!                      "res = struct ('w', [NaN, NaN], 'mass', NaN);\nend\n"]);
%! [count, message, fields] = checkDryRun (folder, 'Toy');
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (folder, 's');
%! assert (count, 2);
%! assert (message, '');
%! assert (fields, {'w', 'mass'});
%!assert (checkDryRun ('/nowhere', 'Toy'), NaN)

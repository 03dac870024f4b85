% UNUSEDVARIABLES  Variables that no file of the models uses.
%
% CALL: NAMES = unusedVariables (NAMES, FOLDERS, PLACES)
%
%   NAMES    1 x n cell of names of variables
%   FOLDERS  1 x M cell of model folders, PLACES of their run folders (texts),
%            see namedFiles
%   NAMES    those that change nothing
%
% A file uses a variable where its name stands in it as a word; an input script
% of LIGGGHTS (in.*) and data.head where they take its value (${a}, v_a, $a). A
% line that declares it, and what stands behind # is no use. Files that scripts
% name outside the model (namedFiles) are looked into, too.

function names = unusedVariables (names, folders, places)
  for k = 1:numel (folders)
    [~, list] = system (['cd ', shellQuote(folders{k}), ' && find -L . ', ...
                         '-type f -size -1000k ! -name "*.stl" ! ', ...
                         '-name "README*" ! -path "./sample/*" ! ', ...
                         '-path "./.git/*" 2> /dev/null']);
    inside = regexp (list, '(?<=\./)[^\n]+', 'match');
    names = without (names, fullfile (folders{k}, inside));
    if ~isempty (names)                 % to find the others takes longer
      names = without (names, namedFiles (folders{k}, places{k}));
    end
  end
end

function names = without (names, files)
  k = 0;
  while k < numel (files) && ~isempty (names)
    k = k + 1;
    names = names(~areIn (names, files{k}));
  end
end

function yes = areIn (names, file)
  fid = fopen (file, 'r');
  text = fread (fid, 1e7, 'uint8=>char')';
  fclose (fid);
  [~, base, ending] = fileparts (file);
  base = [base, ending];
  text(double (text) > 127) = '?';
  text = regexprep (text, '#[^\n]*', '');
  text = regexprep (text, '\<variable[ \t]+\w+[ \t]+\w+', '');
  isScript = strncmp (base, 'in.', 3) || strcmp (base, 'data.head');
  forms = {'\<(v_)?@\>', '\$\{@\}|\<v_@\>|\$@\>'};
  isUsed = @(name) ~isempty (regexp (text, strrep (forms{1 + isScript}, ...
                                                   '@', name), 'once'));
  yes = cellfun (isUsed, names);
end

%!test
%! model = fullfile (tempname (), 'M');
%! mkdir (fullfile (model, 'OctaveFuns'));
%! put = @(name, text) writeAtomic (fullfile (model, name), text);
%! put ('data.head', ["variable a equal 1 # ${d}\nvariable b equal 1\n", ...
%!                    "variable c equal 2*${b}\nvariable d equal 0\n"]);
%! put ('in.M', "variable d equal 3\nprint \"a ${c}\" # ${d}\nfix x v_e\n");
%! put ('runscript', "awk '{ x = v[\"f\"] }' data.head\n../../../../go\n");
%! put ('OctaveFuns/getResults.m', 'gain');
%! put ('README.md', 'd');
%! writeAtomic (fullfile (fileparts (model), 'go'), ["\0bin h\0"]);
%! place = fullfile (fileparts (model), 'x', 'optim', 'M', '0001');
%! names = {'a', 'b', 'c', 'd', 'e', 'f', 'gain', 'h', 'i'};
%! assert (unusedVariables (names, {model}, {place}), {'a', 'd', 'i'});

% SPDX-License-Identifier: GPL-3.0-only

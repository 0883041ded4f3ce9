//! The tree of a text: values, each with its bytes.

use std::borrow::Cow;
use std::ops::Range;

/// A value and where it stands.
#[derive(Debug)]
pub struct Node<'a> {
    /// Its bytes.
    pub span: Range<usize>,
    /// What it is.
    pub value: Value<'a>,
}

/// What a value is.
#[derive(Debug)]
pub enum Value<'a> {
    /// A number; infinite or NaN where these words stand.
    Number(f64),
    /// A number with digits that is too large to be one.
    TooLarge(&'a str),
    /// A text in quotes.
    Text(Cow<'a, str>),
    /// A bare word: `rx`, `None`.
    Word(&'a str),
    /// Anything in brackets.
    Group(Box<Group<'a>>),
}

/// Values in brackets.
#[derive(Debug)]
pub struct Group<'a> {
    /// The word before the bracket.
    pub name: Option<Named<'a>>,
    /// What stands in them.
    pub content: Content<'a>,
}

/// A word and where it stands.
#[derive(Clone, Debug)]
pub struct Named<'a> {
    /// The word.
    pub name: &'a str,
    /// Its bytes.
    pub span: Range<usize>,
}

/// What stands in the brackets.
#[derive(Debug)]
pub enum Content<'a> {
    /// `(name: value, …)`.
    Fields(Vec<(Named<'a>, Node<'a>)>),
    /// `(value, …)`, or nothing.
    Tuple(Vec<Node<'a>>),
    /// `[value, …]`.
    List(Vec<Node<'a>>),
    /// `{key: value, …}`.
    Map(Vec<(Node<'a>, Node<'a>)>),
}

impl<'a> Node<'a> {
    /// As it stands where so many bytes come before its text.
    pub fn moved(mut self, by: usize) -> Self {
        self.shift(by);
        self
    }

    fn shift(&mut self, by: usize) {
        let shift = |span: &mut Range<usize>| *span = span.start + by..span.end + by;
        shift(&mut self.span);
        let Value::Group(group) = &mut self.value else { return };
        group.name.iter_mut().for_each(|name| shift(&mut name.span));
        match &mut group.content {
            Content::Fields(fields) => fields.iter_mut().for_each(|(named, node)| {
                shift(&mut named.span);
                node.shift(by);
            }),
            Content::Tuple(items) | Content::List(items) => items.iter_mut().for_each(|item| item.shift(by)),
            Content::Map(entries) => entries.iter_mut().for_each(|(key, node)| {
                key.shift(by);
                node.shift(by);
            }),
        }
    }

    /// The group, if it is one.
    pub fn group(&self) -> Option<&Group<'a>> {
        if let Value::Group(group) = &self.value { Some(group) } else { None }
    }

    /// The bare word, or the word before the bracket.
    pub fn head(&self) -> Option<Named<'a>> {
        match &self.value {
            Value::Word(name) => Some(Named { name, span: self.span.clone() }),
            Value::Group(group) => group.name.clone(),
            Value::Number(_) | Value::TooLarge(_) | Value::Text(_) => None,
        }
    }

    /// The entries of a map.
    pub fn entries(&self) -> Option<&[(Node<'a>, Node<'a>)]> {
        match &self.group()?.content {
            Content::Map(entries) => Some(entries),
            _ => None,
        }
    }

    /// The values in round brackets without names of fields, whatever stands before the brackets.
    pub fn tuple(&self) -> Option<&[Node<'a>]> {
        match &self.group()?.content {
            Content::Tuple(items) => Some(items),
            _ => None,
        }
    }

    /// The values of a list, or of a tuple without a name.
    pub fn items(&self) -> Option<&[Node<'a>]> {
        match self.group()? {
            Group { content: Content::List(items), .. }
            | Group { name: None, content: Content::Tuple(items) } => Some(items),
            _ => None,
        }
    }

    /// Where a message about the whole value points: the name of a group, or its opening bracket.
    pub fn place(&self) -> Range<usize> {
        match &self.value {
            Value::Group(group) => {
                group.name.as_ref().map_or(self.span.start..self.span.start + 1, |named| named.span.clone())
            }
            _ => self.span.clone(),
        }
    }

    /// What it is, in a message.
    pub fn describe(&self) -> String {
        match &self.value {
            Value::Number(_) | Value::TooLarge(_) => "a number".to_owned(),
            Value::Text(_) => "a text".to_owned(),
            Value::Word(word) => format!("the word '{word}'"),
            Value::Group(group) => match (&group.name, &group.content) {
                (Some(named), _) => format!("'{}(…)'", named.name),
                (None, Content::Fields(_)) => "a group of fields".to_owned(),
                (None, Content::Tuple(items)) => {
                    format!("{} value{} in brackets", items.len(), if items.len() == 1 { "" } else { "s" })
                }
                (None, Content::List(_)) => "a list".to_owned(),
                (None, Content::Map(_)) => "a map".to_owned(),
            },
        }
    }
}
